/* conform/peer: small shell scripts that answer, hang, end, and say too much; and a table. */
#include "etalon/conform/peer.h"
#include "gen.h"
#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

#define HELLO "0 ok protocol=1 name=sh version=1 ops=net_counts"
/* A script that answers each request by `$1`, and never says more than it should. */
#define SCRIPT(answer) "read l; echo '" HELLO "'; while read id rest; do " answer "; done"

/* What comes of a script that does this at each request. */
typedef struct { const char *answer; et_asked how; const char *says; } conduct;

static const conduct conducts[] = {
    { "echo \"$id ok 1 2 3\"", ET_ASKED_REPLY, "" },
    { "echo \"$id refused it is so\"", ET_ASKED_REPLY, "" },
    { "echo \"$id unsupported\"", ET_ASKED_REPLY, "" },
    { "printf '%s ok' \"$id\"; echo \" 1 2 3\"", ET_ASKED_REPLY, "" },
    { "exit 0", ET_ASKED_CRASH, "exit code 0" },
    { "exit 3", ET_ASKED_CRASH, "exit code 3" },
    { "kill -9 $$", ET_ASKED_CRASH, "signal 9" },
    { "printf '%s ok 1 2' \"$id\"; exit 0", ET_ASKED_CRASH, "exit code 0" },
    { "(sleep 20) & exit 0", ET_ASKED_CRASH, "exit code 0" },
    { "echo \"1$id ok 1 2 3\"", ET_ASKED_GARBLED, "answered" },
    { "echo \"$id ok 1 two 3\"", ET_ASKED_GARBLED, "is not a number" },
    { "echo hello", ET_ASKED_GARBLED, "is not the number of a request" },
    { "echo", ET_ASKED_GARBLED, "is not the number of a request" },
    { "printf '%s ok 1\\0 2 3\\n' \"$id\"", ET_ASKED_GARBLED, "zero byte" },
    { "while :; do echo -n 0123456789012345678901234567890123456789012345678901234567890123456789; done", ET_ASKED_GARBLED, "does not end" },
};
enum { CONDUCTS = sizeof conducts / sizeof *conducts };

static bool make_request(gen *g, et_request *r)
{
    return gen_check(g, et_request_new(r, ET_OP_NET_COUNTS) == ET_OK && et_request_set(r, 0, 2 + (size_t)gen_upto(g, 9), NULL) == ET_OK
                            && et_request_set(r, 1, 2, NULL) == ET_OK, "a request is made");
}

static et_status begin(et_peer **peer, et_asked *how, const char *command, double timeout, et_message *message)
{
    const et_peer_program program = { command, timeout, NULL, NULL, NULL };

    return et_peer_start(peer, how, &program, message);
}

/* One case in 20. */
verdict prop_peer_start(gen *g)
{
    static const struct { const char *command; double timeout; et_status status; et_asked how; const char *says; } starts[] = {
        { SCRIPT("echo \"$id ok\""), 60, ET_OK, ET_ASKED_REPLY, "" },
        { "exit 0", 60, ET_EFORMAT, ET_ASKED_CRASH, "exit code 0" },
        { "kill -11 $$", 60, ET_EFORMAT, ET_ASKED_CRASH, "signal 11" },
        { "read l; echo '0 ok protocol=2 name=a version=1 ops=span'; read l", 60, ET_EFORMAT, ET_ASKED_GARBLED, "protocol=2" },
        { "read l; echo '1 ok protocol=1 name=a version=1 ops=span'; read l", 60, ET_EFORMAT, ET_ASKED_GARBLED, "does not begin" },
        { "read l; echo '0 refused'; read l", 60, ET_EFORMAT, ET_ASKED_GARBLED, "does not begin" },
        { "exec sleep 30", 0.05, ET_EFORMAT, ET_ASKED_TIMEOUT, "no reply" },
        { "./there/is/no/such/program", 60, ET_EIO, ET_ASKED_CRASH, "cannot start" },
        { "exit 126", 60, ET_EIO, ET_ASKED_CRASH, "cannot start" },
        { NULL, 60, ET_EINVAL, ET_ASKED_REPLY, "" },
        { "exit 0", 0, ET_EINVAL, ET_ASKED_REPLY, "" },
    };
    const size_t k = (size_t)gen_upto(g, sizeof starts / sizeof *starts - 1);
    et_peer *peer = NULL;
    et_asked how = ET_ASKED_REPLY;
    et_message message = { "" };
    const et_status status = begin(&peer, &how, starts[k].command, starts[k].timeout, &message);
    bool ok = gen_check(g, status == starts[k].status, "%s: status %d, not %d: %s", starts[k].command, (int)status, (int)starts[k].status,
                        message.text);
    ok = ok && gen_check(g, status != ET_EFORMAT || how == starts[k].how, "%s: how %d, not %d", starts[k].command, (int)how, (int)starts[k].how);
    ok = ok && gen_check(g, strstr(message.text, starts[k].says) != NULL, "%s: '%s' does not say '%s'", starts[k].command, message.text,
                         starts[k].says);
    ok = ok && gen_check(g, (status == ET_OK) == (peer != NULL), "a peer only where it began");
    et_peer_stop(peer);
    return ok ? PASS : FAIL;
}

/* The next request after trouble finds a program started again. */
/* One case in 20. */
verdict prop_peer_ask(gen *g)
{
    const conduct *c = &conducts[gen_upto(g, CONDUCTS - 1)];
    char command[400];
    et_message message = { "" };
    et_peer *peer = NULL;
    et_request request;
    et_asked how;

    snprintf(command, sizeof command, "read l; echo '" HELLO "'; while read id rest; do %s; done", c->answer);
    if (!make_request(g, &request))
        return FAIL;
    bool ok = gen_check(g, begin(&peer, &how, command, 60, &message) == ET_OK, "%s: %s", command, message.text);
    for (int again = 0; ok && again < 2; again++) {
        et_reply reply, was;
        memset(&reply, 0, sizeof reply);
        was = reply;
        message.text[0] = '\0';
        ok = gen_check(g, et_peer_ask(peer, &how, &reply, &request, &message) == ET_OK, "%s: %s", c->answer, message.text);
        ok = ok && gen_check(g, how == c->how, "%s: how %d, not %d: %s", c->answer, (int)how, (int)c->how, message.text);
        if (ok && how == ET_ASKED_REPLY)
            ok = gen_check(g, reply.kind != ET_REPLY_OK || (reply.count == 3 && reply.x[0] == 1 && reply.x[1] == 2 && reply.x[2] == 3),
                           "%s: the reply", c->answer);
        else
            ok = ok && gen_check(g, memcmp(&reply, &was, sizeof reply) == 0 && strstr(message.text, c->says), "%s: '%s'", c->answer, message.text);
        et_reply_free(&reply);
    }
    et_peer_stop(peer);
    et_request_free(&request);
    return ok ? PASS : FAIL;
}

/* Hanging, and bytes that nothing asked for, at the second request. */
/* One case in 50. */
verdict prop_peer_ask_late(gen *g)
{
    static const conduct late[] = {
        { "sleep 30", ET_ASKED_TIMEOUT, "no reply" },
        { "printf '%s ok 1' \"$id\"; sleep 30", ET_ASKED_TIMEOUT, "no reply" },
        { "echo \"$id ok 1 2 3\"; echo \"$id ok 1 2 3\"", ET_ASKED_GARBLED, "" },
        { "exec >&-; sleep 30", ET_ASKED_CRASH, "closed its" },
        { "trap '' TERM INT HUP PIPE; sleep 30", ET_ASKED_TIMEOUT, "no reply" },
    };
    const conduct *c = &late[gen_upto(g, sizeof late / sizeof *late - 1)];
    const bool hangs = c->how == ET_ASKED_TIMEOUT;
    char command[400];
    et_message message = { "" };
    et_peer *peer = NULL;
    et_request request;
    et_asked how = ET_ASKED_REPLY;

    /* Only the time limit of those that hang is short: a busy machine may be slow to start a shell. */
    snprintf(command, sizeof command, "read l; echo '" HELLO "'; while read id rest; do %s; done", c->answer);
    if (!make_request(g, &request))
        return FAIL;
    const et_status began = begin(&peer, &how, command, hangs ? 0.5 : 60, &message);
    if (hangs && began == ET_EFORMAT && how == ET_ASKED_TIMEOUT) {
        et_request_free(&request);
        return SKIP;
    }
    bool ok = gen_check(g, began == ET_OK, "%s: %s", command, message.text);
    for (int k = 0; ok && k < (c->how == ET_ASKED_GARBLED ? 2 : 1); k++) {
        et_reply reply;
        memset(&reply, 0, sizeof reply);
        ok = gen_check(g, et_peer_ask(peer, &how, &reply, &request, &message) == ET_OK, "asked");
        et_reply_free(&reply);
    }
    ok = ok && gen_check(g, how == c->how && strstr(message.text, c->says), "%s: how %d, '%s'", c->answer, (int)how, message.text);
    et_peer_stop(peer);
    et_request_free(&request);
    return ok ? PASS : FAIL;
}

/* The program's number, which it answers. */
static bool number_of(gen *g, et_peer *peer, pid_t *pid)
{
    et_request request;
    et_reply reply;
    et_asked how;

    memset(&reply, 0, sizeof reply);
    if (!make_request(g, &request))
        return false;
    bool ok = gen_check(g, et_peer_ask(peer, &how, &reply, &request, NULL) == ET_OK && how == ET_ASKED_REPLY && reply.count == 1,
                        "it answers its number");
    if (ok)
        *pid = (pid_t)reply.x[0];
    et_reply_free(&reply);
    et_request_free(&request);
    return ok;
}

/* Nobody stays, neither a program that ends by itself nor one that does not, nor its children. */
/* One case in 150. */
verdict prop_peer_stop(gen *g)
{
    static const char *const commands[] = {
        SCRIPT("echo \"$id ok $$\""),
        "read l; echo '" HELLO "'; read id rest; echo \"$id ok $$\"; exec sleep 30",
        "read l; echo '" HELLO "'; sleep 30 & read id rest; echo \"$id ok $!\"; wait",
    };
    const size_t k = (size_t)gen_upto(g, 2);
    et_message message = { "" };
    et_peer *peer = NULL;
    et_asked how;
    pid_t pid = 0;
    const bool began = gen_check(g, begin(&peer, &how, commands[k], k == 0 ? 60 : 5, &message) == ET_OK, "%s", message.text);
    bool ok = began && number_of(g, peer, &pid);

    et_peer_stop(peer);
    et_peer_stop(NULL);
    /* A child's end is noticed by init, soon. */
    for (int wait = 0; ok && k == 2 && wait < 400 && kill(pid, 0) == 0; wait++)
        (void)poll(NULL, 0, 10);
    ok = ok && gen_check(g, kill(pid, 0) != 0 && errno == ESRCH, "process %d is left", (int)pid);
    return ok ? PASS : FAIL;
}

/* One case in 40. */
verdict prop_peer_kill(gen *g)
{
    et_message message = { "" };
    et_peer *peer = NULL;
    et_request request;
    et_reply reply;
    et_asked how;
    pid_t first = 0, second = 0;
    bool ok = gen_check(g, begin(&peer, &how, SCRIPT("echo \"$id ok $$\""), 60, &message) == ET_OK, "%s", message.text) && number_of(g, peer, &first);

    et_peer_kill(NULL);
    memset(&reply, 0, sizeof reply);
    if (ok && make_request(g, &request)) {
        et_peer_kill(peer);
        ok = gen_check(g, et_peer_ask(peer, &how, &reply, &request, &message) == ET_OK && how == ET_ASKED_CRASH, "a killed one has crashed: %s",
                       message.text);
        et_request_free(&request);
    }
    ok = ok && number_of(g, peer, &second) && gen_check(g, first != second, "and is started again");
    et_peer_stop(peer);
    return ok ? PASS : FAIL;
}

/* One case in 40. */
verdict prop_peer_hello(gen *g)
{
    et_message message = { "" };
    et_peer *peer = NULL;
    et_asked how;
    char command[200];
    const size_t degree = (size_t)gen_upto(g, 20);

    snprintf(command, sizeof command, "read l; echo '" HELLO ",span degree=%zu'; read l", degree);
    bool ok = gen_check(g, begin(&peer, &how, command, 60, &message) == ET_OK, "%s", message.text);
    if (ok) {
        const et_hello *h = et_peer_hello(peer);
        ok = gen_check(g, strcmp(h->name, "sh") == 0 && h->degree == degree && h->op[ET_OP_SPAN] && h->op[ET_OP_NET_COUNTS] && !h->op[ET_OP_BASIS],
                       "what it said");
    }
    et_peer_stop(peer);
    return ok ? PASS : FAIL;
}

/* A program that ends at each request, and says another hello for each process if `changes`. */
/* One case in 40. */
verdict prop_peer_changed(gen *g)
{
    static const char *const commands[] = {
        "read l; echo '" HELLO "'; read l; exit 1",
        "read l; echo \"" HELLO " degree=$$\"; read l; exit 1",
    };
    const size_t changes = (size_t)gen_upto(g, 1);
    et_message message = { "" };
    et_peer *peer = NULL;
    et_request request;
    et_reply reply;
    et_asked how;

    if (!make_request(g, &request))
        return FAIL;
    memset(&reply, 0, sizeof reply);
    bool ok = gen_check(g, begin(&peer, &how, commands[changes], 60, &message) == ET_OK, "%s", message.text);
    for (int k = 0; ok && k < 2; k++)
        ok = gen_check(g, et_peer_changed(peer) == 0, "nothing has changed yet") && et_peer_ask(peer, &how, &reply, &request, NULL) == ET_OK;
    ok = ok && gen_check(g, et_peer_changed(peer) == (int)changes, "changed: %d", et_peer_changed(peer));
    et_peer_stop(peer);
    et_request_free(&request);
    return ok ? PASS : FAIL;
}

/* ---- tables ---- */

static et_status answer(void *context, et_reply *reply, const et_request *request)
{
    const double x = (double)request->arg[0].count;

    ++*(size_t *)context;
    memset(reply, 0, sizeof *reply);
    return et_reply_put(reply, &x, 1);
}

verdict prop_peer_wrap(gen *g)
{
    size_t calls = 0;
    et_peer_table table;
    et_peer *peer = NULL;
    et_request request;
    et_reply reply;
    et_asked how = ET_ASKED_CRASH;

    memset(&table, 0, sizeof table);
    table.context = &calls;
    table.hello.degree = 5;
    bool ok = gen_check(g, et_peer_wrap(&peer, &table) == ET_EINVAL && !peer, "a table without an answer");
    table.answer = answer;
    if (!ok || !make_request(g, &request))
        return FAIL;
    memset(&reply, 0, sizeof reply);
    ok = gen_check(g, et_peer_wrap(&peer, &table) == ET_OK && et_peer_hello(peer)->degree == 5 && et_peer_changed(peer) == 0, "wrapped");
    ok = ok && gen_check(g, et_peer_ask(peer, &how, &reply, &request, NULL) == ET_OK && how == ET_ASKED_REPLY && calls == 1, "asked");
    ok = ok && gen_check(g, reply.count == 1 && reply.x[0] == (double)request.arg[0].count, "its answer");
    et_peer_kill(peer);
    et_peer_stop(peer);
    et_reply_free(&reply);
    et_request_free(&request);
    return ok ? PASS : FAIL;
}
