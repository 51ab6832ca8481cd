/* conform/peer: what is no program, a caller that ignores how its children end, time limits below a second. */
#include "etalon/conform/peer.h"
#include "gen.h"
#include <math.h>
#include <signal.h>
#include <string.h>
#include <time.h>

verdict prop_peer_start_arguments(gen *g);
verdict prop_peer_ask_unknown_end(gen *g);
verdict prop_peer_stop_short(gen *g);

#define HELLO "read l; echo '0 ok protocol=1 name=sh version=1 ops=net_counts'; "

static et_status begin(et_peer **peer, et_asked *how, const char *command, double timeout, et_message *message)
{
    const et_peer_program program = { command, timeout, NULL, NULL, NULL };

    message->text[0] = '\0';
    return et_peer_start(peer, how, &program, message);
}

/* One case in 1000. */
verdict prop_peer_start_arguments(gen *g)
{
    static const struct { const char *command; double timeout; } all[] = {
        { NULL, 5 }, { "cat", 0 }, { "cat", -1 }, { "cat", (double)NAN }, { NULL, 0 } };
    bool ok = true;

    for (size_t k = 0; ok && k < sizeof all / sizeof *all; k++) {
        et_peer *peer = NULL;
        et_asked how = ET_ASKED_TIMEOUT;
        et_message message;
        const et_status status = begin(&peer, &how, all[k].command, all[k].timeout, &message);
        ok = gen_check(g, status == ET_EINVAL && !peer && how == ET_ASKED_TIMEOUT, "case %zu: status %d", k, (int)status)
             && gen_check(g, strcmp(message.text, "no command, or no time for it") == 0, "%s", message.text);
    }
    return ok ? PASS : FAIL;
}

static et_status ask(et_peer *peer, et_asked *how, et_message *text)
{
    et_request r;
    et_reply reply;
    et_status status = et_request_new(&r, ET_OP_NET_COUNTS);

    memset(&reply, 0, sizeof reply);
    text->text[0] = '\0';
    if (status == ET_OK)
        status = et_peer_ask(peer, how, &reply, &r, text);
    et_reply_free(&reply);
    et_request_free(&r);
    return status;
}

/* Where SIGCHLD is ignored the system forgets how a program ended: no exit code and no signal are then told, and it is started again all the same. */
/* One case in 1000. */
verdict prop_peer_ask_unknown_end(gen *g)
{
    static const char *const ends[] = { "read l; exit 3", "read l; kill -9 $$", "exit 0" };
    struct sigaction ignored, before;
    bool ok = true;

    memset(&ignored, 0, sizeof ignored);
    ignored.sa_handler = SIG_IGN;
    sigemptyset(&ignored.sa_mask);
    sigaction(SIGCHLD, &ignored, &before);
    for (size_t k = 0; ok && k < sizeof ends / sizeof *ends; k++) {
        char command[200] = HELLO;
        et_peer *peer = NULL;
        et_asked how = ET_ASKED_TIMEOUT;
        et_message message;
        strcat(command, ends[k]);
        ok = gen_check(g, begin(&peer, &how, command, 60, &message) == ET_OK, "%s: %s", command, message.text);
        for (int n = 0; ok && n < 2; n++)
            ok = gen_check(g, ask(peer, &how, &message) == ET_OK && how == ET_ASKED_CRASH, "%s: how %d: %s", command, (int)how, message.text)
                 && gen_check(g, strcmp(message.text, "it ended instead of replying") == 0, "%s: %s", command, message.text);
        et_peer_stop(peer);
    }
    sigaction(SIGCHLD, &before, NULL);
    return ok ? PASS : FAIL;
}

/* A program that does not end with its input is given the time limit, a second at most, and killed. */
/* One case in 1000. */
verdict prop_peer_stop_short(gen *g)
{
    struct timespec start, end;
    et_peer *peer = NULL;
    et_asked how = ET_ASKED_REPLY;
    et_message message;

    const et_status status = begin(&peer, &how, HELLO "sleep 30", 0.4, &message);
    if (status == ET_EFORMAT && how == ET_ASKED_TIMEOUT)
        return PASS;                      /* too busy a machine for so short a time limit */
    if (!gen_check(g, status == ET_OK, "%s", message.text))
        return FAIL;
    clock_gettime(CLOCK_MONOTONIC, &start);
    et_peer_stop(peer);
    clock_gettime(CLOCK_MONOTONIC, &end);
    const double seconds = (double)(end.tv_sec - start.tv_sec) + 1e-9 * (double)(end.tv_nsec - start.tv_nsec);
    return gen_check(g, seconds >= 0.39 && seconds < 20, "it took %g seconds", seconds) ? PASS : FAIL;
}
