#include "etalon/conform/peer.h"
#include "conform/request_words.h"
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

extern char **environ;

/* Milliseconds between two looks at the clock, at the caller's wish to stop, and at the program's life; bytes read at once; starts in a row; time
 * limits for a hello, before which interpreters and libraries are loaded. */
enum { SLICE = 50, CHUNK = 1 << 16, STARTS = 3, PATIENCE = 2 };

struct et_peer {
    et_peer_table table;                  /* answer is null for a program; its hello is the first one's */
    et_peer_program program;
    char *command;
    pid_t pid;                            /* 0: none runs */
    int in, out;                          /* its standard input and output, our ends */
    char *read;                           /* bytes that have come and are not used up */
    size_t length, room;
    uint64_t asked;
    int changed;
};

static double now(void)
{
    struct timespec t = { 0, 0 };

    (void)clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void tell(const et_peer *peer, char what, const char *text, size_t length)
{
    if (peer->program.trace)
        peer->program.trace(peer->program.context, what, text, length);
}

/* ---- the process ---- */

/* Our end of a pipe: not inherited, never waited for. */
static int prepare(int fd)
{
    return fcntl(fd, F_SETFD, FD_CLOEXEC) == 0 && fcntl(fd, F_SETFL, O_NONBLOCK) == 0;
}

static void close_both(const int fd[2])
{
    close(fd[0]);
    close(fd[1]);
}

/* Signals that a program around us may ignore are not ignored by ours; nothing is blocked. */
static int set_attributes(posix_spawnattr_t *a)
{
    static const int numbers[] = { SIGPIPE, SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXFSZ };
    sigset_t defaults, none;

    sigemptyset(&none);
    sigemptyset(&defaults);
    for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++)
        sigaddset(&defaults, numbers[k]);
    return posix_spawnattr_setflags(a, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK) == 0
           && posix_spawnattr_setpgroup(a, 0) == 0 && posix_spawnattr_setsigdefault(a, &defaults) == 0 && posix_spawnattr_setsigmask(a, &none) == 0;
}

/* 1 if the command is nothing but a program and its arguments: no operators, assignments or expansions, and not one of the shell's own words. */
static int is_plain(const char *command)
{
    static const char *const own[] = { ".", ":", "alias", "bg", "break", "case", "cd", "command", "continue", "eval", "exec", "exit", "export", "fc",
                                       "fg",
                                       "for", "hash", "if", "jobs", "local", "read", "readonly", "return", "set", "shift", "times", "trap", "type",
                                       "ulimit", "umask", "unalias", "unset", "until", "wait", "while" };
    const char *first = command + strspn(command, " \t");
    const size_t length = strcspn(first, " \t");

    if (length == 0 || strpbrk(command, ";&|<>()$`={}#!\n"))
        return 0;
    for (size_t k = 0; k < sizeof own / sizeof *own; k++)
        if (strlen(own[k]) == length && memcmp(own[k], first, length) == 0)
            return 0;
    return 1;
}

/* What the shell is given.  A plain command takes the shell's place, so that nobody but it holds the pipes, and its end by a signal is seen. */
static char *shell_command(const char *command)
{
    const char *before = is_plain(command) ? "exec " : "";
    const size_t length = strlen(before) + strlen(command) + 1;
    char *text = malloc(length);

    if (text) {
        memcpy(text, before, strlen(before));
        memcpy(text + strlen(before), command, strlen(command) + 1);
    }
    return text;
}

/* 0, or the error's number. */
static int spawn(pid_t *pid, const char *command, int in, int out)
{
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t a;
    char *arguments[] = { (char[]){ "sh" }, (char[]){ "-c" }, NULL, NULL };
    int error = ENOMEM;

    arguments[2] = shell_command(command);
    if (!arguments[2])
        return error;
    if (posix_spawn_file_actions_init(&actions) == 0) {
        if (posix_spawnattr_init(&a) == 0) {
            if (set_attributes(&a) && posix_spawn_file_actions_adddup2(&actions, in, 0) == 0
                && posix_spawn_file_actions_adddup2(&actions, out, 1) == 0
                && posix_spawn_file_actions_addclose(&actions, in) == 0 && posix_spawn_file_actions_addclose(&actions, out) == 0)
                error = posix_spawn(pid, "/bin/sh", &actions, &a, arguments, environ);
            posix_spawnattr_destroy(&a);
        }
        posix_spawn_file_actions_destroy(&actions);
    }
    free(arguments[2]);
    return error;
}

static et_status begin(et_peer *peer, et_message *message)
{
    int in[2], out[2], error;
    pid_t pid = 0;

    if (pipe(in) != 0)
        return et_status_fail(message, ET_EIO, "cannot start %s: %s", peer->command, strerror(errno));
    if (pipe(out) != 0) {
        error = errno;
        close_both(in);
        return et_status_fail(message, ET_EIO, "cannot start %s: %s", peer->command, strerror(error));
    }
    error = prepare(in[1]) && prepare(out[0]) ? spawn(&pid, peer->command, in[0], out[1]) : errno;
    if (error) {
        close_both(in);
        close_both(out);
        return et_status_fail(message, error == ENOMEM ? ET_ENOMEM : ET_EIO, "cannot start %s: %s", peer->command, strerror(error));
    }
    close(in[0]);
    close(out[1]);
    peer->pid = pid;
    peer->in = in[1];
    peer->out = out[0];
    peer->length = 0;
    tell(peer, '!', "started", 7);
    return ET_OK;
}

/* 1 if the program has ended; it stays a zombie, so that its number, and its group's, remain its own.  *info is then set, or, where a program around
 * us ignores SIGCHLD, so that nobody can know how its children end, zero. */
static int ended(const et_peer *peer, siginfo_t *info)
{
    memset(info, 0, sizeof *info);
    return waitid(P_PID, (id_t)peer->pid, info, WEXITED | WNOHANG | WNOWAIT) != 0 ? errno != EINTR : info->si_pid != 0;
}

/* ended() within so many seconds. */
static int ends(const et_peer *peer, siginfo_t *info, double seconds)
{
    const double until = now() + seconds;

    while (!ended(peer, info)) {
        if (now() >= until)
            return 0;
        (void)poll(NULL, 0, 2);
    }
    return 1;
}

static void finish(et_peer *peer)
{
    if (peer->pid == 0)
        return;
    (void)kill(-peer->pid, SIGKILL);
    if (peer->in >= 0)
        close(peer->in);
    close(peer->out);
    while (waitpid(peer->pid, NULL, 0) < 0 && errno == EINTR)
        ;
    peer->pid = 0;
    peer->length = 0;
    tell(peer, '!', "ended", 5);
}

/* What became of a program that talks no more, as a sentence. */
static et_asked crash(const et_peer *peer, et_message *text)
{
    siginfo_t info;

    if (!ends(peer, &info, 0.5))
        et_status_fail(text, ET_OK, "it closed its input or its output instead of replying");
    else if (info.si_pid == 0)
        et_status_fail(text, ET_OK, "it ended instead of replying");
    else if (info.si_code == CLD_EXITED && info.si_status > 128 && info.si_status < 160)
        et_status_fail(text, ET_OK, "it ended with exit code %d, which is signal %d (%s)", info.si_status, info.si_status - 128,
                       strsignal(info.si_status - 128));
    else if (info.si_code == CLD_EXITED)
        et_status_fail(text, ET_OK, "it ended with exit code %d instead of replying", info.si_status);
    else
        et_status_fail(text, ET_OK, "it was ended by signal %d (%s)", info.si_status, strsignal(info.si_status));
    return ET_ASKED_CRASH;
}

/* ---- a line there, a line back ---- */

/* Of a call that failed: it may be tried again. */
static int may_pass(int error)
{
    return error == EAGAIN || error == EINTR;
}

typedef struct {
    const char *line;                     /* with its end */
    size_t length, written, seen;         /* seen: bytes of the reply in which there is no line end */
    size_t most;                          /* bytes that the reply may have */
    double until;
    int deaf;                             /* it closed its input */
} exchange;

/* write() without the signal that ends programs whose reader has gone, whatever they do with it. */
static ssize_t write_quietly(int fd, const char *bytes, size_t length)
{
    sigset_t pipe_signal, before, pending;
    const struct timespec none = { 0, 0 };

    sigemptyset(&pipe_signal);
    sigaddset(&pipe_signal, SIGPIPE);
    sigemptyset(&pending);
    (void)sigpending(&pending);
    pthread_sigmask(SIG_BLOCK, &pipe_signal, &before);
    const ssize_t n = write(fd, bytes, length);
    const int error = errno;
    if (n < 0 && error == EPIPE && !sigismember(&pending, SIGPIPE))
        (void)sigtimedwait(&pipe_signal, NULL, &none);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    errno = error;
    return n;
}

static void write_some(et_peer *peer, exchange *e)
{
    const ssize_t n = write_quietly(peer->in, e->line + e->written, e->length - e->written);

    if (n > 0)
        e->written += (size_t)n;
    else if (n < 0 && !may_pass(errno))
        e->deaf = 1;
}

typedef enum { CAME, NOTHING, CLOSED, NO_MEMORY } came;

static came read_some(et_peer *peer)
{
    if (peer->room - peer->length < CHUNK) {
        const size_t room = 2 * peer->room + CHUNK;
        char *more = realloc(peer->read, room);
        if (!more)
            return NO_MEMORY;
        peer->read = more;
        peer->room = room;
    }
    const ssize_t n = read(peer->out, peer->read + peer->length, CHUNK);
    if (n < 0)
        return may_pass(errno) ? NOTHING : CLOSED;
    if (n == 0)
        return CLOSED;
    tell(peer, '<', peer->read + peer->length, (size_t)n);
    peer->length += (size_t)n;
    return CAME;
}

/* 1 if a whole line stands at the beginning of what was read. */
static int has_line(const et_peer *peer, exchange *e)
{
    if (peer->length > e->seen && memchr(peer->read + e->seen, '\n', peer->length - e->seen))
        return 1;
    e->seen = peer->length;
    return 0;
}

/* What may be written and read now; *open becomes 0 at the end of the output. */
static et_status turn(et_peer *peer, exchange *e, int *open)
{
    struct pollfd fd[2] = { { peer->out, POLLIN, 0 }, { e->written < e->length && !e->deaf ? peer->in : -1, POLLOUT, 0 } };
    siginfo_t info;
    const int n = poll(fd, 2, SLICE);
    came c = CAME;

    if (n < 0)
        return may_pass(errno) ? ET_OK : ET_EIO;
    if (fd[1].revents)
        write_some(peer, e);
    if (fd[0].revents)
        c = read_some(peer);
    else if ((n == 0 || e->deaf) && ended(peer, &info)) {
        /* A child of it may hold the pipe open; what it wrote before its end is there by now. */
        do
            c = read_some(peer);
        while (c == CAME && peer->length <= e->most);
        *open = 0;
    } else if (e->deaf && n == 0)
        *open = 0;
    if (c == CLOSED)
        *open = 0;
    return c == NO_MEMORY ? ET_ENOMEM : ET_OK;
}

/* The line is written and one is read: it stands at the beginning of what was read, up to its '\n'. */
static et_status exchange_lines(et_peer *peer, et_asked *how, exchange *e, et_message *text)
{
    et_status status;
    int open = 1;

    while (!has_line(peer, e)) {
        *how = ET_ASKED_GARBLED;
        if (peer->length > e->most)
            return et_status_fail(text, ET_OK, "its reply does not end: more than %zu bytes", e->most);
        if (!open) {
            *how = crash(peer, text);
            return ET_OK;
        }
        *how = ET_ASKED_TIMEOUT;
        if (now() > e->until)
            return et_status_fail(text, ET_OK, "no reply within the time limit of %g seconds", peer->program.timeout);
        if ((status = et_task_step(peer->program.stop, 0, 0)) != ET_OK)
            return et_status_fail(text, status, "%s", et_status_text(status));
        if ((status = turn(peer, e, &open)) != ET_OK)
            return et_status_fail(text, status, "%s", et_status_text(status));
    }
    *how = e->written == e->length ? ET_ASKED_REPLY : ET_ASKED_GARBLED;
    if (*how == ET_ASKED_GARBLED)
        et_status_fail(text, ET_OK, "it replied before it had read the request");
    return ET_OK;
}

/* Bytes that came while nothing was asked. */
static et_status unasked(et_peer *peer, et_asked *how, et_message *text)
{
    const came c = read_some(peer);

    if (c == NO_MEMORY)
        return et_status_fail(text, ET_ENOMEM, "out of memory");
    *how = ET_ASKED_REPLY;
    if (peer->length > 0) {
        *how = ET_ASKED_GARBLED;
        et_status_fail(text, ET_OK, "%zu bytes came that nothing had asked for", peer->length);
    } else if (c == CLOSED) {
        *how = crash(peer, text);
    }
    return ET_OK;
}

/* Ask a line; *line is the reply, without its end, in the peer's memory until take() frees it. */
static et_status ask_line(et_peer *peer, et_asked *how, char **line, const char *request, size_t most, double seconds, et_message *text)
{
    exchange e = { request, strlen(request), 0, 0, most, now() + seconds, 0 };
    et_status status = unasked(peer, how, text);

    if (status != ET_OK || *how != ET_ASKED_REPLY)
        return status;
    tell(peer, '>', request, e.length);
    status = exchange_lines(peer, how, &e, text);
    if (status != ET_OK || *how != ET_ASKED_REPLY)
        return status;
    char *end = memchr(peer->read, '\n', peer->length);
    *end = '\0';
    *line = peer->read;
    if (strlen(*line) != (size_t)(end - peer->read)) {
        *how = ET_ASKED_GARBLED;
        et_status_fail(text, ET_OK, "its reply has a zero byte");
    }
    return ET_OK;
}

/* The first line is used up. */
static void take(et_peer *peer)
{
    const size_t n = strlen(peer->read) + 1;

    memmove(peer->read, peer->read + n, peer->length - n);
    peer->length -= n;
}

/* ---- hello ---- */

static et_status read_hello(et_hello *hello, const char *line, et_message *message)
{
    request_words words = { line };
    const char *word;
    uint64_t id;
    const size_t length = request_words_next(&word, &words);

    if (!request_words_count(&id, word, length) || id != 0 || request_words_next(&word, &words) != 2 || memcmp(word, "ok", 2) != 0)
        return et_status_fail(message, ET_EFORMAT, "hello: the reply does not begin with `0 ok `: %.80s", line);
    return et_reply_hello(hello, words.at, message);
}

/* *how and *text say what came instead of a hello.  ET_EIO: the shell could not start the command. */
static et_status say_hello(et_peer *peer, et_asked *how, et_hello *hello, et_message *text)
{
    enum { MOST = 1 << 14 };
    siginfo_t info;
    char *line;
    et_status status = ask_line(peer, how, &line, "0 hello 1\n", MOST, PATIENCE * peer->program.timeout, text);

    if (status == ET_OK && *how == ET_ASKED_CRASH && peer->length == 0 && ended(peer, &info) && info.si_code == CLD_EXITED
        && (info.si_status == 126 || info.si_status == 127))
        status = et_status_fail(text, ET_EIO, "cannot start %s: the shell's exit code is %d", peer->command, info.si_status);
    if (status == ET_OK && *how == ET_ASKED_TIMEOUT)
        et_status_fail(text, ET_OK, "no reply to hello within %g seconds; is its output flushed?", PATIENCE * peer->program.timeout);
    if (status != ET_OK || *how != ET_ASKED_REPLY)
        return status;
    status = read_hello(hello, line, text);
    if (status == ET_EFORMAT) {
        *how = ET_ASKED_GARBLED;
        return ET_OK;
    }
    if (status == ET_OK)
        take(peer);
    return status;
}

static int same_hello(const et_hello *a, const et_hello *b)
{
    return strcmp(a->name, b->name) == 0 && strcmp(a->version, b->version) == 0 && a->degree == b->degree && a->order == b->order
           && a->rational == b->rational && a->any == b->any && a->left == b->left && a->right == b->right && !(a->knot_tolerance < b->knot_tolerance)
           && !(a->knot_tolerance > b->knot_tolerance) && memcmp(a->op, b->op, sizeof a->op) == 0 && a->unknown == b->unknown;
}

static et_status begin_again(et_peer *peer, et_message *text)
{
    et_message why = { "" };
    et_hello hello;
    et_asked how;

    for (int k = 0; k < STARTS; k++) {
        et_status status = begin(peer, text);
        if (status != ET_OK)
            return status;
        status = say_hello(peer, &how, &hello, &why);
        if (status == ET_OK && how == ET_ASKED_REPLY) {
            peer->changed = peer->changed || !same_hello(&hello, &peer->table.hello);
            return ET_OK;
        }
        finish(peer);
        if (status != ET_OK)
            return et_status_fail(text, status, "%.900s", why.text);
    }
    return et_status_fail(text, ET_EIO, "it does not start any more: %.900s", why.text);
}

/* ---- the interface ---- */

et_status et_peer_start(et_peer **peer, et_asked *how, const et_peer_program *program, et_message *message)
{
    et_asked came_instead = ET_ASKED_REPLY;

    if (!program->command || !(program->timeout > 0))
        return et_status_fail(message, ET_EINVAL, "no command, or no time for it");
    et_peer *made = calloc(1, sizeof *made);
    if (!made || !(made->command = strdup(program->command))) {
        free(made);
        return et_status_fail(message, ET_ENOMEM, "out of memory");
    }
    made->program = *program;
    et_status status = begin(made, message);
    if (status == ET_OK)
        status = say_hello(made, &came_instead, &made->table.hello, message);
    if (status == ET_OK && came_instead != ET_ASKED_REPLY)
        status = ET_EFORMAT;
    if (status != ET_OK) {
        finish(made);
        et_peer_stop(made);
        *how = came_instead;
        return status;
    }
    *how = ET_ASKED_REPLY;
    *peer = made;
    return ET_OK;
}

et_status et_peer_wrap(et_peer **peer, const et_peer_table *table)
{
    if (!table->answer)
        return ET_EINVAL;
    et_peer *made = calloc(1, sizeof *made);
    if (!made)
        return ET_ENOMEM;
    made->table = *table;
    *peer = made;
    return ET_OK;
}

/* A program is told by the end of its input; one that has not ended after a while is killed. */
void et_peer_stop(et_peer *peer)
{
    siginfo_t info;

    if (!peer)
        return;
    if (peer->pid != 0) {
        close(peer->in);
        peer->in = -1;
        (void)ends(peer, &info, peer->program.timeout < 1 ? peer->program.timeout : 1);
        finish(peer);
    }
    free(peer->command);
    free(peer->read);
    free(peer);
}

void et_peer_kill(const et_peer *peer)
{
    if (peer && peer->pid != 0)
        (void)kill(-peer->pid, SIGKILL);
}

const et_hello *et_peer_hello(const et_peer *peer)
{
    return &peer->table.hello;
}

int et_peer_changed(const et_peer *peer)
{
    return peer->changed;
}

static double count_named(const et_request *request, const char *name)
{
    const et_request_shape *shape;

    for (size_t k = 0; (shape = et_request_argument(request->op, k)) != NULL; k++)
        if (strcmp(shape->name, name) == 0)
            return (double)request->arg[k].count;
    return 0;
}

/* Bytes that a reply may have: with N numbers in the request, orders or repetitions r, and n knots or control points, no answer has more than
 * (N + 16)(r + 1)^2 + 4 n_u n_v numbers, of 48 bytes at most, and some room for words; never more than 2^28. */
static size_t reply_room(const et_request *request)
{
    const et_request_shape *shape;
    double numbers = 16;

    for (size_t k = 0; (shape = et_request_argument(request->op, k)) != NULL; k++)
        numbers += shape->kind == ET_ARG_COUNT || shape->kind == ET_ARG_WORD ? 1
                   : shape->kind == ET_ARG_REAL ? 1 : (shape->kind == ET_ARG_POINTS ? 3 : 1) * (double)request->arg[k].count;
    const double r = 1 + count_named(request, request->op == ET_OP_BASIS_DERS || request->op == ET_OP_CURVE_DERS || request->op == ET_OP_SURFACE_DERS
                                                  ? "d" : request->op == ET_OP_FIT_GRID || request->op == ET_OP_SURFACE_ERROR ? "" : "r");
    const double u = count_named(request, "u") + count_named(request, "nu") + count_named(request, "n") + count_named(request, "nx");
    const double v = 1 + count_named(request, "v") + count_named(request, "nv") + count_named(request, "ny");
    const double bytes = 4096 + 48 * (numbers * r * r + 4 * u * v + count_named(request, "p") + count_named(request, "q"));

    return bytes < 0x1p28 ? (size_t)bytes : (size_t)1 << 28;
}

/* "ID LINE\n"; ET_ENOMEM. */
static et_status write_request(char **line, uint64_t id, const et_request *request)
{
    request_line made = { NULL, 0, 0, 0 };
    char *body;
    et_status status = et_request_print(&body, request);

    if (status != ET_OK)
        return status;
    request_line_count(&made, id);
    request_line_text(&made, " ");
    request_line_text(&made, body);
    request_line_text(&made, "\n");
    free(body);
    return request_line_end(line, &made);
}

/* The reply on the line, if it is one and has this number. */
static et_status read_reply(et_asked *how, et_reply *reply, const char *line, uint64_t asked, et_message *text)
{
    et_reply read;
    uint64_t id;
    const et_status status = et_reply_parse(&read, &id, line, text);

    if (status == ET_ENOMEM)
        return status;
    *how = status == ET_OK && id == asked ? ET_ASKED_REPLY : ET_ASKED_GARBLED;
    if (status == ET_OK && id != asked) {
        et_status_fail(text, ET_OK, "answered %llu when asked %llu", (unsigned long long)id, (unsigned long long)asked);
        et_reply_free(&read);
    }
    if (*how == ET_ASKED_REPLY)
        *reply = read;
    return ET_OK;
}

static et_status ask_program(et_peer *peer, et_asked *how, et_reply *reply, const et_request *request, et_message *text)
{
    char *line, *answer;
    et_status status = peer->pid == 0 ? begin_again(peer, text) : ET_OK;

    if (status == ET_OK && (status = write_request(&line, ++peer->asked, request)) != ET_OK)
        et_status_fail(text, status, "out of memory");
    if (status != ET_OK)
        return status;
    status = ask_line(peer, how, &answer, line, reply_room(request), peer->program.timeout, text);
    free(line);
    if (status == ET_OK && *how == ET_ASKED_REPLY)
        status = read_reply(how, reply, answer, peer->asked, text);
    if (status == ET_OK && *how == ET_ASKED_REPLY)
        take(peer);
    else
        finish(peer);
    return status;
}

et_status et_peer_ask(et_peer *peer, et_asked *how, et_reply *reply, const et_request *request, et_message *text)
{
    et_message unheard;

    if (!peer->table.answer)
        return ask_program(peer, how, reply, request, text ? text : &unheard);
    const et_status status = peer->table.answer(peer->table.context, reply, request);
    if (status == ET_OK)
        *how = ET_ASKED_REPLY;
    return status;
}
