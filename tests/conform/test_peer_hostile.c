/* conform/peer: programs that can hardly be started, that hang, leave and come back as others. */
#include "etalon/conform/answer.h"
#include "etalon/conform/campaign.h"
#include "etalon/conform/peer.h"
#include "gen.h"
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

verdict prop_peer_start_hello(gen *g);
verdict prop_peer_start_nothing_left(gen *g);
verdict prop_peer_start_interrupted(gen *g);
verdict prop_peer_start_stopped(gen *g);
verdict prop_peer_start_plain(gen *g);
verdict prop_peer_ask_ends(gen *g);
verdict prop_peer_ask_deaf(gen *g);
verdict prop_peer_ask_unasked(gen *g);
verdict prop_peer_ask_again(gen *g);
verdict prop_peer_ask_every_operation(gen *g);
verdict prop_peer_ask_table(gen *g);
verdict prop_peer_changed_each(gen *g);

#define HELLO "0 ok protocol=1 name=sh version=1 ops=net_counts"

static et_status begin(et_peer **peer, et_asked *how, const char *command, double timeout, et_message *message)
{
    const et_peer_program program = { command, timeout, NULL, NULL, NULL };

    message->text[0] = '\0';
    *peer = NULL;
    return et_peer_start(peer, how, &program, message);
}

/* net_counts nx ny. */
static bool counts(gen *g, et_request *r, size_t nx, size_t ny)
{
    return gen_check(g, et_request_new(r, ET_OP_NET_COUNTS) == ET_OK && et_request_set(r, 0, nx, NULL) == ET_OK
                            && et_request_set(r, 1, ny, NULL) == ET_OK, "a request is made");
}

/* One request; its reply is of no interest. */
static et_status ask(et_peer *peer, et_asked *how, const et_request *r, et_message *text)
{
    et_reply reply;

    memset(&reply, 0, sizeof reply);
    text->text[0] = '\0';
    const et_status status = et_peer_ask(peer, how, &reply, r, text);
    et_reply_free(&reply);
    return status;
}

static bool says(gen *g, const char *command, const et_message *message, const char *text)
{
    return gen_check(g, strstr(message->text, text) != NULL, "%.200s: '%s' does not say '%s'", command, message->text, text);
}

/* A name that is no file's. */
static bool flag(gen *g, char path[64])
{
    strcpy(path, "/tmp/etalon-peer-XXXXXX");
    const int fd = mkstemp(path);

    if (fd >= 0) {
        close(fd);
        unlink(path);
    }
    return gen_check(g, fd >= 0, "a temporary file is made");
}

/* One case in 1000. */
verdict prop_peer_start_hello(gen *g)
{
    static const struct { const char *command; et_status status; et_asked how; const char *says; } starts[] = {
        { "read l; echo 'x ok protocol=1 name=a version=1 ops=span'; read l", ET_EFORMAT, ET_ASKED_GARBLED, "does not begin" },
        { "read l; echo; read l", ET_EFORMAT, ET_ASKED_GARBLED, "does not begin" },
        { "read l; echo '0 okay protocol=1 name=a version=1 ops=span'; read l", ET_EFORMAT, ET_ASKED_GARBLED, "does not begin" },
        { "read l; echo '0 no protocol=1 name=a version=1 ops=span'; read l", ET_EFORMAT, ET_ASKED_GARBLED, "does not begin" },
        { "read l; echo '0 ok protocol=1 name=a ops=span'; read l", ET_EFORMAT, ET_ASKED_GARBLED, "version" },
        { "read l; printf '0 ok\\0 protocol=1\\n'; read l", ET_EFORMAT, ET_ASKED_GARBLED, "zero byte" },
        { "read l; head -c 40000 /dev/zero; read l", ET_EFORMAT, ET_ASKED_GARBLED, "does not end" },
        { "read l; printf '0 ok'; exit 0", ET_EFORMAT, ET_ASKED_CRASH, "exit code 0" },
        { "read l; printf '0 ok'; exit 127", ET_EFORMAT, ET_ASKED_CRASH, "exit code 127" },
        { "exit 125", ET_EFORMAT, ET_ASKED_CRASH, "exit code 125" },
        { "exit 127", ET_EIO, ET_ASKED_CRASH, "cannot start" },
        { "exit 139", ET_EFORMAT, ET_ASKED_CRASH, "which is signal 11" },
        { "exit 200", ET_EFORMAT, ET_ASKED_CRASH, "exit code 200 instead" },
        { "kill -9 $$", ET_EFORMAT, ET_ASKED_CRASH, "by signal 9" },
        { "read l; exec >&-; sleep 30", ET_EFORMAT, ET_ASKED_CRASH, "closed its" },
        { "", ET_EFORMAT, ET_ASKED_CRASH, "exit code 0" },
        { " \t", ET_EFORMAT, ET_ASKED_CRASH, "exit code 0" },
        { "true", ET_EFORMAT, ET_ASKED_CRASH, "exit code 0" },
    };
    bool ok = true;

    for (size_t k = 0; ok && k < sizeof starts / sizeof *starts; k++) {
        et_message message;
        et_asked how = ET_ASKED_REPLY;
        et_peer *peer;
        const et_status status = begin(&peer, &how, starts[k].command, 60, &message);
        ok = gen_check(g, status == starts[k].status && how == starts[k].how && !peer, "%s: status %d, how %d: %s", starts[k].command, (int)status,
                       (int)how, message.text);
        ok = ok && says(g, starts[k].command, &message, starts[k].says);
        et_peer_stop(peer);
    }
    return ok ? PASS : FAIL;
}

/* So many descriptors may be opened. */
static bool allow(int more)
{
    static rlim_t usual;
    struct rlimit limit;
    int first;

    if (getrlimit(RLIMIT_NOFILE, &limit) != 0)
        return false;
    usual = usual > 0 ? usual : limit.rlim_cur;
    first = dup(0);
    if (first >= 0)
        close(first);
    limit.rlim_cur = more < 0 || first < 0 ? usual : (rlim_t)(first + more);
    return setrlimit(RLIMIT_NOFILE, &limit) == 0;
}

/* No descriptors for the first pipe or the second, at the first start or later; a command that is longer than any may be. */
/* One case in 1000. */
verdict prop_peer_start_nothing_left(gen *g)
{
    enum { LONG = 1 << 18 };
    static const char command[] = "read l; echo '" HELLO "'; read l; exit 1";
    char *const longer = malloc(LONG);
    et_message message;
    et_asked how = ET_ASKED_REPLY;
    et_request r;
    et_peer *peer;
    bool ok = longer && counts(g, &r, 2, 2);

    for (int more = 0; ok && more < 4; more++) {
        ok = gen_check(g, allow(more), "a limit is set");
        const et_status status = begin(&peer, &how, command, 60, &message);
        ok = gen_check(g, allow(-1) && status == ET_EIO && !peer, "%d descriptors: status %d, %s", more, (int)status, message.text) && ok;
        ok = ok && says(g, command, &message, "cannot start");
    }
    ok = ok && gen_check(g, begin(&peer, &how, command, 60, &message) == ET_OK && ask(peer, &how, &r, &message) == ET_OK && how == ET_ASKED_CRASH,
                         "it starts, and ends");
    if (ok) {
        (void)allow(0);
        const et_status status = ask(peer, &how, &r, &message);
        ok = gen_check(g, allow(-1) && status == ET_EIO, "status %d: %s", (int)status, message.text) && says(g, command, &message, "cannot start");
        et_peer_stop(peer);
    }
    if (ok) {
        memset(longer, 'x', LONG - 1);
        longer[LONG - 1] = '\0';
        ok = gen_check(g, begin(&peer, &how, longer, 60, &message) == ET_EIO && !peer, "a command of %d bytes", LONG - 1);
        et_request_free(&r);
    }
    free(longer);
    return ok ? PASS : FAIL;
}

static volatile sig_atomic_t alarms;

static void on_alarm(int number)
{
    (void)number;
    alarms++;
}

/* Signals that come while a reply is waited for do not matter. */
/* One case in 1000. */
verdict prop_peer_start_interrupted(gen *g)
{
    const struct itimerval often = { { 0, 2000 }, { 0, 2000 } }, never = { { 0, 0 }, { 0, 0 } };
    struct sigaction action, before;
    et_message message;
    et_asked how = ET_ASKED_CRASH;
    et_request r;
    et_peer *peer;

    if (!counts(g, &r, 2, 2))
        return FAIL;
    memset(&action, 0, sizeof action);
    action.sa_handler = on_alarm;
    sigemptyset(&action.sa_mask);
    sigaction(SIGALRM, &action, &before);
    setitimer(ITIMER_REAL, &often, NULL);
    bool ok = gen_check(g, begin(&peer, &how, "read l; echo '" HELLO "'; while read id rest; do sleep 0.1; echo \"$id ok 1\"; done", 60, &message)
                               == ET_OK, "it starts: %s", message.text);
    ok = ok && gen_check(g, ask(peer, &how, &r, &message) == ET_OK && how == ET_ASKED_REPLY, "it answers: %s", message.text);
    et_peer_stop(peer);
    setitimer(ITIMER_REAL, &never, NULL);
    sigaction(SIGALRM, &before, NULL);
    et_request_free(&r);
    return ok && gen_check(g, alarms > 0, "no alarm came") ? PASS : FAIL;
}

static et_status stop_at(void *context, size_t done, size_t total)
{
    (void)done, (void)total;
    return --*(int *)context <= 0 ? ET_ESTOPPED : ET_OK;
}

/* Whoever waits may give up: at the hello, and at a request. */
/* One case in 1000. */
verdict prop_peer_start_stopped(gen *g)
{
    int looks = 1;
    const et_task stop = { stop_at, &looks };
    et_peer_program program = { "sleep 30", 60, NULL, NULL, &stop };
    et_message message = { "" };
    et_asked how = ET_ASKED_REPLY;
    et_peer *peer = NULL;
    et_request r;
    bool ok = gen_check(g, et_peer_start(&peer, &how, &program, &message) == ET_ESTOPPED && !peer, "stopped at the hello: %s", message.text);

    looks = 1 << 20;
    program.command = "read l; echo '" HELLO "'; sleep 30";
    ok = ok && counts(g, &r, 2, 2) && gen_check(g, et_peer_start(&peer, &how, &program, &message) == ET_OK, "started: %s", message.text);
    if (ok) {
        looks = 2;
        ok = gen_check(g, ask(peer, &how, &r, &message) == ET_ESTOPPED, "stopped at a request: %s", message.text);
        et_peer_stop(peer);
        et_request_free(&r);
    }
    return ok ? PASS : FAIL;
}

typedef struct { size_t written, read, happened; } heard;

static void hear(void *context, char what, const char *text, size_t length)
{
    heard *h = context;

    h->written += what == '>' ? length : 0;
    h->read += what == '<' ? length : 0;
    h->happened += what == '!' && text[0] != '\0';
}

/* A command that is nothing but a program and its arguments takes the shell's place; what is said is heard. */
/* One case in 1000. */
verdict prop_peer_start_plain(gen *g)
{
    char path[64], command[100];
    heard h = { 0, 0, 0 };
    et_peer_program program = { command, 60, hear, &h, NULL };
    et_message message = { "" };
    et_asked how = ET_ASKED_CRASH;
    et_peer *peer = NULL;
    et_request r;

    if (!flag(g, path) || !counts(g, &r, 2, 2))
        return FAIL;
    FILE *file = fopen(path, "w");
    bool ok = gen_check(g, file != NULL, "a script is written");
    if (ok) {
        fputs("read l; echo '" HELLO "'; read id rest; echo \"$id ok 1\"; read id rest; kill -6 $$\n", file);
        ok = fclose(file) == 0;
    }
    snprintf(command, sizeof command, "  sh %s", path);
    ok = ok && gen_check(g, et_peer_start(&peer, &how, &program, &message) == ET_OK, "started: %s", message.text);
    ok = ok && gen_check(g, ask(peer, &how, &r, &message) == ET_OK && how == ET_ASKED_REPLY, "answered: %s", message.text);
    ok = ok && gen_check(g, ask(peer, &how, &r, &message) == ET_OK && how == ET_ASKED_CRASH, "its end") && says(g, command, &message, "by signal 6");
    ok = ok && gen_check(g, h.written == strlen("0 hello 1\n1 net_counts 2 2\n2 net_counts 2 2\n") && h.read == strlen(HELLO "\n1 ok 1\n")
                                && h.happened == 2, "%zu bytes written, %zu read, %zu events", h.written, h.read, h.happened);
    et_peer_stop(peer);
    unlink(path);
    et_request_free(&r);
    return ok ? PASS : FAIL;
}

/* What a program does at a request instead of answering it. */
typedef struct { const char *answer; et_asked how; const char *says; double timeout; } conduct;

static bool conducts_itself(gen *g, const conduct *c, const et_request *r)
{
    char command[400];
    et_message message;
    et_asked how = ET_ASKED_REPLY;
    et_peer *peer;

    snprintf(command, sizeof command, "read l; echo '" HELLO "'; %s", c->answer);
    const et_status began = begin(&peer, &how, command, c->timeout, &message);
    if (c->timeout < 2 && began == ET_EFORMAT && how == ET_ASKED_TIMEOUT)
        return true;                      /* too busy a machine for so short a time limit */
    bool ok = gen_check(g, began == ET_OK, "%s: %s", command, message.text);
    ok = ok && gen_check(g, ask(peer, &how, r, &message) == ET_OK && how == c->how, "%s: how %d: %s", command, (int)how, message.text);
    ok = ok && says(g, command, &message, c->says);
    et_peer_stop(peer);
    return ok;
}

/* One case in 1000. */
verdict prop_peer_ask_ends(gen *g)
{
    static const conduct all[] = {
        { "read l; exit 139", ET_ASKED_CRASH, "which is signal 11", 60 },
        { "read l; exit 160", ET_ASKED_CRASH, "exit code 160 instead", 60 },
        { "read l; exec >&-; sleep 30", ET_ASKED_CRASH, "closed its", 60 },
        { "read l; kill -15 $$", ET_ASKED_CRASH, "by signal 15", 60 },
        { "(sleep 3) & read l; exit 3", ET_ASKED_CRASH, "exit code 3", 60 },
        { "(sleep 3) & read l; printf '1 ok 1'; exit 3", ET_ASKED_CRASH, "exit code 3", 60 },
        { "(sleep 3) & read l; printf '1 ok 1\\n'; exit 3", ET_ASKED_REPLY, "", 60 },
        { "read l; sleep 30", ET_ASKED_TIMEOUT, "no reply", 0.3 },
        { "read l; head -c 100000 /dev/zero; sleep 30", ET_ASKED_GARBLED, "does not end", 60 },
    };
    et_request r;
    bool ok = counts(g, &r, 2, 2);

    if (!ok)
        return FAIL;
    for (size_t k = 0; ok && k < sizeof all / sizeof *all; k++)
        ok = conducts_itself(g, &all[k], &r);
    et_request_free(&r);
    return ok ? PASS : FAIL;
}

/* A request too long for a pipe. */
static bool long_request(gen *g, et_request *r)
{
    enum { N = 30000 };
    static double x[3 * N];

    return gen_check(g, et_request_new(r, ET_OP_PARAMETERS) == ET_OK && et_request_set(r, 1, N, x) == ET_OK, "a long request is made");
}

/* Programs that do not read, or do not listen any more; a reader that has gone does not end us, whatever is done with that signal. */
/* One case in 1000. */
verdict prop_peer_ask_deaf(gen *g)
{
    static const conduct all[] = {
        { "exec <&-; sleep 30", ET_ASKED_CRASH, "closed its", 60 },
        { "sleep 0.3; exit 4", ET_ASKED_CRASH, "exit code 4", 60 },
        { "sleep 30", ET_ASKED_TIMEOUT, "no reply", 0.3 },
        { "sleep 0.5; echo '1 ok 1'; sleep 30", ET_ASKED_GARBLED, "", 60 },
    };
    const struct timespec none = { 0, 0 };
    sigset_t pipe_signal, before;
    et_request r;
    bool ok = long_request(g, &r);

    if (!ok)
        return FAIL;
    for (size_t k = 0; ok && k < sizeof all / sizeof *all; k++)
        ok = conducts_itself(g, &all[k], &r);
    /* One that was pending before stays so. */
    sigemptyset(&pipe_signal);
    sigaddset(&pipe_signal, SIGPIPE);
    sigprocmask(SIG_BLOCK, &pipe_signal, &before);
    raise(SIGPIPE);
    ok = ok && conducts_itself(g, &all[0], &r);
    ok = gen_check(g, sigtimedwait(&pipe_signal, NULL, &none) == SIGPIPE, "the signal is still there") && ok;
    sigprocmask(SIG_SETMASK, &before, NULL);
    et_request_free(&r);
    return ok ? PASS : FAIL;
}

/* Bytes, or the end, that come before anything is asked. */
/* One case in 1000. */
verdict prop_peer_ask_unasked(gen *g)
{
    static const conduct all[] = {
        { "read l", ET_ASKED_GARBLED, "nothing had asked for", 60 },
        { "exit 5", ET_ASKED_CRASH, "exit code 5", 60 },
    };
    et_message message;
    et_asked how = ET_ASKED_REPLY;
    et_request r;
    bool ok = counts(g, &r, 2, 2);

    if (!ok)
        return FAIL;
    for (size_t k = 0; ok && k < 2; k++) {
        char command[200];
        et_peer *peer;
        snprintf(command, sizeof command, "read l; printf '" HELLO "\\n%s'; %s", k == 0 ? "more\\n" : "", all[k].answer);
        ok = gen_check(g, begin(&peer, &how, command, 60, &message) == ET_OK, "%s: %s", command, message.text);
        (void)poll(NULL, 0, 300);
        ok = ok && gen_check(g, ask(peer, &how, &r, &message) == ET_OK && how == all[k].how, "%s: how %d: %s", command, (int)how, message.text);
        ok = ok && says(g, command, &message, all[k].says);
        et_peer_stop(peer);
    }
    et_request_free(&r);
    return ok ? PASS : FAIL;
}

/* A program that finds a file where it has been before. */
typedef struct {
    char path[64], command[600];
    et_message message;
    et_asked how;
    et_request r;
    et_peer *peer;
} returning;

static bool returning_new(gen *g, returning *c)
{
    c->how = ET_ASKED_REPLY;
    return flag(g, c->path) && counts(g, &c->r, 2, 2);
}

/* It is started for the first time. */
static bool returning_first(gen *g, returning *c)
{
    unlink(c->path);
    return gen_check(g, begin(&c->peer, &c->how, c->command, 60, &c->message) == ET_OK, "%s: %s", c->command, c->message.text);
}

static verdict returning_end(returning *c, bool ok)
{
    unlink(c->path);
    et_request_free(&c->r);
    return ok ? PASS : FAIL;
}

/* A program that starts once only, and what it does when it is started again. */
/* One case in 1000. */
verdict prop_peer_ask_again(gen *g)
{
    static const struct { const char *again, *says; } all[] = {
        { "exit 3", "does not start any more: it ended with exit code 3" }, { "exit 127", "cannot start" },
        { "read l; echo hello; read l", "does not start any more: hello: " } };
    returning c;

    if (!returning_new(g, &c))
        return FAIL;
    bool ok = true;
    for (size_t k = 0; ok && k < sizeof all / sizeof *all; k++) {
        snprintf(c.command, sizeof c.command, "[ -e %s ] && { %s; }; : > %s; read l; echo '" HELLO "'; read l; exit 1", c.path, all[k].again, c.path);
        ok = returning_first(g, &c);
        ok = ok && gen_check(g, ask(c.peer, &c.how, &c.r, &c.message) == ET_OK && c.how == ET_ASKED_CRASH, "it ends: %s", c.message.text);
        ok = ok && gen_check(g, ask(c.peer, &c.how, &c.r, &c.message) == ET_EIO, "it does not come back: %s", c.message.text)
             && says(g, c.command, &c.message, all[k].says);
        et_peer_stop(c.peer);
    }
    return returning_end(&c, ok);
}

/* Whatever is asked, a short reply has room; a request for more than any reply may hold, too. */
/* One case in 1000. */
verdict prop_peer_ask_every_operation(gen *g)
{
    static const char command[] = "read l; echo '" HELLO "'; while read id rest; do echo \"$id refused all\"; done";
    const et_hello all = et_answer_hello(1);
    et_message message;
    et_asked how = ET_ASKED_CRASH;
    et_peer *peer;
    bool ok = gen_check(g, begin(&peer, &how, command, 60, &message) == ET_OK, "%s", message.text);

    for (int op = 0; ok && op <= ET_OPS; op++) {
        et_request r;
        if (op == ET_OPS ? !counts(g, &r, 1 << 20, 1 << 20)
                         : !gen_check(g, et_campaign_draw(&r, (et_request_op)op, ET_CATEGORY_PLAIN, 1, 1, &all) == ET_OK, "drawn"))
            break;
        ok = gen_check(g, ask(peer, &how, &r, &message) == ET_OK && how == ET_ASKED_REPLY, "operation %d: %s", op, message.text);
        et_request_free(&r);
    }
    et_peer_stop(peer);
    return ok ? PASS : FAIL;
}

static et_status no_memory(void *context, et_reply *reply, const et_request *request)
{
    (void)context, (void)reply, (void)request;
    return ET_ENOMEM;
}

/* One case in 1000. */
verdict prop_peer_ask_table(gen *g)
{
    et_peer_table table;
    et_message message = { "" };
    et_asked how = ET_ASKED_CRASH;
    et_peer *peer = NULL;
    et_request r;

    memset(&table, 0, sizeof table);
    table.answer = no_memory;
    bool ok = counts(g, &r, 2, 2);
    if (!ok)
        return FAIL;
    ok = gen_check(g, et_peer_wrap(&peer, &table) == ET_OK, "wrapped");
    ok = ok && gen_check(g, ask(peer, &how, &r, &message) == ET_ENOMEM && how == ET_ASKED_CRASH, "its failure is ours");
    et_peer_stop(peer);
    et_request_free(&r);
    return ok ? PASS : FAIL;
}

/* Started again, every key of hello may be another; the order of the words does not matter. */
/* One case in 1000. */
verdict prop_peer_changed_each(gen *g)
{
#define BASE "0 ok protocol=1 name=a version=1 degree=3 order=2 rational=1 sides=any,left knot_tolerance=0x1p-20 ops=span,basis,fold"
    static const struct { const char *again; int changed; } all[] = {
        { BASE, 0 },
        { "0 ok version=1 protocol=1 name=a order=2 degree=3 rational=1 sides=left,any knot_tolerance=0x1p-20 ops=fold,basis,span", 0 },
        { "0 ok protocol=1 name=b version=1 degree=3 order=2 rational=1 sides=any,left knot_tolerance=0x1p-20 ops=span,basis,fold", 1 },
        { "0 ok protocol=1 name=a version=2 degree=3 order=2 rational=1 sides=any,left knot_tolerance=0x1p-20 ops=span,basis,fold", 1 },
        { "0 ok protocol=1 name=a version=1 degree=4 order=2 rational=1 sides=any,left knot_tolerance=0x1p-20 ops=span,basis,fold", 1 },
        { "0 ok protocol=1 name=a version=1 degree=3 order=3 rational=1 sides=any,left knot_tolerance=0x1p-20 ops=span,basis,fold", 1 },
        { "0 ok protocol=1 name=a version=1 degree=3 order=2 rational=0 sides=any,left knot_tolerance=0x1p-20 ops=span,basis,fold", 1 },
        { "0 ok protocol=1 name=a version=1 degree=3 order=2 rational=1 sides=left knot_tolerance=0x1p-20 ops=span,basis,fold", 1 },
        { "0 ok protocol=1 name=a version=1 degree=3 order=2 rational=1 sides=any knot_tolerance=0x1p-20 ops=span,basis,fold", 1 },
        { "0 ok protocol=1 name=a version=1 degree=3 order=2 rational=1 sides=any,left,right knot_tolerance=0x1p-20 ops=span,basis,fold", 1 },
        { "0 ok protocol=1 name=a version=1 degree=3 order=2 rational=1 sides=any,left knot_tolerance=0x1p-21 ops=span,basis,fold", 1 },
        { "0 ok protocol=1 name=a version=1 degree=3 order=2 rational=1 sides=any,left knot_tolerance=0x1p-19 ops=span,basis,fold", 1 },
        { "0 ok protocol=1 name=a version=1 degree=3 order=2 rational=1 sides=any,left knot_tolerance=0x1p-20 ops=span,fold", 1 },
        { "0 ok protocol=1 name=a version=1 degree=3 order=2 rational=1 sides=any,left knot_tolerance=0x1p-20 ops=span,basis", 1 },
    };
    returning c;

    if (!returning_new(g, &c))
        return FAIL;
    bool ok = true;
    for (size_t k = 0; ok && k < sizeof all / sizeof *all; k++) {
        snprintf(c.command, sizeof c.command, "read l; if [ -e %s ]; then echo '%s'; else : > %s; echo '" BASE "'; fi; read l; exit 1", c.path, all[k].again,
                 c.path);
        ok = returning_first(g, &c);
        for (int n = 0; ok && n < 3; n++)
            ok = gen_check(g, et_peer_changed(c.peer) == (n > 1 ? all[k].changed : 0), "'%s' after %d ends", all[k].again, n)
                 && gen_check(g, ask(c.peer, &c.how, &c.r, &c.message) == ET_OK, "asked: %s", c.message.text);
        et_peer_stop(c.peer);
    }
    return returning_end(&c, ok);
}
