/* conform/conform: the levels above the first, frozen vectors, programs that hang and end, and errors at every place. */
#include "etalon/conform/answer.h"
#include "etalon/conform/conform.h"
#include "conform/report.h"
#include "gen.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

verdict prop_conform_run_frozen(gen *g);
verdict prop_conform_run_frozen_broken(gen *g);
verdict prop_conform_run_empty_offer(gen *g);
verdict prop_conform_run_relations(gen *g);
verdict prop_conform_run_fails(gen *g);
verdict prop_conform_run_hangs(gen *g);
verdict prop_conform_run_crashes(gen *g);
verdict prop_conform_run_comes_back(gen *g);
verdict prop_conform_run_relations_end(gen *g);

/* ---- tables ---- */

/* Answers rightly but for what is told: the numbers of `op` (ET_OPS: of all) moved by `off`; declined; nothing after `most` calls but this status. */
typedef struct { et_request_op op; double off; int declines; size_t calls, most; et_status status; } context;

static et_status answer(void *at, et_reply *reply, const et_request *request)
{
    context *c = at;

    if (++c->calls > c->most)
        return c->status;
    const int its = c->op == ET_OPS || request->op == c->op;
    if (its && c->declines) {
        memset(reply, 0, sizeof *reply);
        reply->kind = ET_REPLY_UNSUPPORTED;
        return ET_OK;
    }
    const et_status status = et_answer_fast(reply, request);
    for (size_t k = 0; status == ET_OK && its && k < reply->count; k++)
        reply->x[k] += c->off;
    return status;
}

static et_peer *wrap(context *c, const et_hello *hello)
{
    et_peer_table table;
    et_peer *peer = NULL;

    memset(&table, 0, sizeof table);
    table.hello = *hello;
    table.answer = answer;
    table.context = c;
    return et_peer_wrap(&peer, &table) == ET_OK ? peer : NULL;
}

/* Etalon's hello, with these operations. */
static et_hello offer(const et_request_op *ops, size_t n)
{
    et_hello hello = et_answer_hello(0);

    memset(hello.op, 0, sizeof hello.op);
    for (size_t k = 0; k < n; k++)
        hello.op[ops[k]] = 1;
    return hello;
}

static et_conform_options ask_for(const et_request_op *ops, size_t n)
{
    et_conform_options o = et_conform_defaults();

    memset(o.op, 0, sizeof o.op);
    for (size_t k = 0; k < n; k++)
        o.op[ops[k]] = 1;
    o.cases = 0;
    return o;
}

/* ---- frozen vectors ---- */

typedef struct { const char *name, *text; } page;

#define PAGE(op, vectors) "{\"format\": \"etalon-conformance\", \"version\": 1, \"operation\": \"" op "\", \"vectors\": [" vectors "]}"
#define KNOTS "1 6 0x0p+0 0x0p+0 0x1p-1 0x1p-1 0x1p+0 0x1p+0 "
#define COUNT(id, issue, x, want) "{\"id\": \"multiplicity/plain/" id "\", \"category\": \"plain\", \"validity\": \"valid\", \"request\": \"4 0x0p+0 0x1p+0 0x1p+0 0x1p+1 " x \
    "\", \"want\": [\"" want "\"], \"bound\": [\"0x0p+0\"], \"condition\": \"0x1p+0\"" issue "}"
#define LIKE(where) ", \"issue\": \"https://" where "\""

static const page pages[] = {
    { "schema", "{}" },
    { "multiplicity", PAGE("multiplicity", COUNT("1", LIKE("a"), "0x0p+0", "1") ", " COUNT("2", LIKE("a"), "0x1p+0", "2") ", "
                           COUNT("3", LIKE("b"), "0x1p+1", "1") ", " COUNT("4", "", "-0x1p+0", "0") ", " COUNT("5", "", "0x1p+2", "0")) },
    { "curve_point", PAGE("curve_point",
        "{\"id\": \"curve_point/weights/1\", \"category\": \"weights\", \"validity\": \"valid\", \"request\": \"1 4 0x0p+0 0x0p+0 0x1p+0 0x1p+0 2 0x0p+0 "
        "0x0p+0 0x0p+0 0x1p+0 0x1p+0 0x1p+0 2 0x1p+0 0x1p+0 0x1p+0 any\", \"want\": [\"0x1p+0\", \"0x1p+0\", \"0x1p+0\"], \"bound\": [\"0x1p-40\", "
        "\"0x1p-40\", \"0x1p-40\"], \"condition\": \"0x1p+0\"}") },
    { "greville", PAGE("greville",
        "{\"id\": \"greville/plain/1\", \"category\": \"plain\", \"validity\": \"implementation_defined\", \"request\": \"0 2 0x0p+0 0x1p+0\"}") },
    { "span", PAGE("span", "{\"id\": \"span/plain/1\"}") },
};
enum { PAGES = sizeof pages / sizeof *pages };

static bool fill(gen *g, char folder[64], size_t from, size_t to)
{
    bool ok = gen_check(g, mkdtemp(strcpy(folder, "/tmp/etalon-vectors-XXXXXX")) != NULL, "a folder is made");

    for (size_t k = from; ok && k < to; k++) {
        char path[128];
        snprintf(path, sizeof path, "%s/%s.json", folder, pages[k].name);
        FILE *file = fopen(path, "w");
        ok = gen_check(g, file && fputs(pages[k].text, file) >= 0, "%s is written", path);
        ok = file && fclose(file) == 0 && ok;
    }
    return ok;
}

static void empty(const char *folder)
{
    for (size_t k = 0; k < PAGES; k++) {
        char path[128];
        snprintf(path, sizeof path, "%s/%s.json", folder, pages[k].name);
        unlink(path);
    }
    rmdir(folder);
}

/* What is not offered is not asked; faults are told once an issue; vectors without a file are none. */
/* One case in 1000. */
verdict prop_conform_run_frozen(gen *g)
{
    static const et_request_op ops[] = { ET_OP_MULTIPLICITY, ET_OP_CURVE_POINT, ET_OP_NET_CLASS };
    et_conform_options o = ask_for(ops, 3);
    char folder[64];
    bool ok = fill(g, folder, 0, PAGES - 1);

    o.level = 1;
    o.vectors = folder;
    o.findings = 10;
    for (int k = 0; ok && k < 4; k++) {
        context c = { ET_OP_MULTIPLICITY, k == 1 ? 1 : 0, 0, 0, SIZE_MAX, ET_OK };
        et_hello hello = et_answer_hello(0);
        et_message message;
        et_conform_report r;
        hello.rational = k != 2;
        hello.op[ET_OP_CURVE_POINT] = k != 3;
        et_peer *peer = wrap(&c, &hello);
        ok = gen_check(g, peer && et_conform_run(&r, peer, &o, NULL, &message) == ET_OK, "run %d: %s", k, message.text);
        ok = ok && gen_check(g, count_of(&r, ET_OP_MULTIPLICITY, ET_VERDICT_WRONG) >= (k == 1 ? 5u : 0u) && (k == 1) == (bad_of(&r) > 0), "faults");
        ok = ok && gen_check(g, r.count[ET_OP_CURVE_POINT][ET_CATEGORY_WEIGHTS][ET_VERDICT_UNSUPPORTED] >= (k >= 2 ? 1u : 0u), "not offered");
        size_t issues = 0, vectors = 0;
        for (size_t f = 0; ok && f < r.findings; f++) {
            issues += r.finding[f].issue != NULL;
            vectors += r.finding[f].vector != NULL;
            ok = gen_check(g, r.finding[f].op == ET_OP_MULTIPLICITY, "and nowhere else");
        }
        ok = ok && gen_check(g, issues == (k == 1 ? 2 : 0) && vectors == issues, "%zu issues, %zu vectors", issues, vectors);
        et_conform_free(&r);
        et_peer_stop(peer);
    }
    empty(folder);
    return ok ? PASS : FAIL;
}

/* A page that is none ends the run, a folder that is none, too. */
/* One case in 1000. */
verdict prop_conform_run_frozen_broken(gen *g)
{
    static const et_request_op ops[] = { ET_OP_SPAN };
    const et_hello hello = et_answer_hello(0);
    et_conform_options o = ask_for(ops, 1);
    char folder[64];
    bool ok = true;

    o.level = 1;
    for (int k = 0; ok && k < 3; k++) {
        context c = { ET_OPS, 0, 0, 0, SIZE_MAX, ET_OK };
        et_peer *peer = wrap(&c, &hello);
        et_message message;
        et_conform_report r;
        ok = fill(g, folder, k == 1, k == 2 ? PAGES - 1 : PAGES);
        o.vectors = folder;
        const et_status status = et_conform_run(&r, peer, &o, NULL, k == 1 ? NULL : &message);
        ok = ok && gen_check(g, status == (k == 0 ? ET_EFORMAT : k == 1 ? ET_EIO : ET_OK) && r.asked > 0, "%d: status %d", k, (int)status);
        ok = ok && gen_check(g, k != 0 || strstr(message.text, "span.json"), "'%s'", message.text);
        et_conform_free(&r);
        et_peer_stop(peer);
        empty(folder);
    }
    return ok ? PASS : FAIL;
}

/* Offered, but nothing of it can be drawn, and the one vector is declined: told all the same. */
/* One case in 1000. */
verdict prop_conform_run_empty_offer(gen *g)
{
    static const et_request_op ops[] = { ET_OP_GREVILLE };
    et_conform_options o = ask_for(ops, 1);
    context c = { ET_OP_GREVILLE, 0, 1, 0, SIZE_MAX, ET_OK };
    et_hello hello = et_answer_hello(0);
    et_conform_report r;
    char folder[64];

    hello.degree = 0;
    et_peer *peer = wrap(&c, &hello);
    o.level = 1;
    o.vectors = folder;
    bool ok = peer && fill(g, folder, 0, PAGES - 1) && gen_check(g, et_conform_run(&r, peer, &o, NULL, NULL) == ET_OK, "the run");
    ok = ok && gen_check(g, r.asked == 1 && r.findings == 1 && bad_of(&r) == 1 && count_of(&r, ET_OP_GREVILLE, ET_VERDICT_WRONGLY_REFUSED) == 1
                                && strstr(r.finding[0].judgement.text, "hello offers it"), "one fault");
    et_conform_free(&r);
    et_peer_stop(peer);
    empty(folder);
    return ok ? PASS : FAIL;
}

/* ---- level 3 ---- */

static const et_request_op related[] = { ET_OP_SPAN, ET_OP_GREVILLE, ET_OP_NET_COUNTS, ET_OP_NET_CLASS, ET_OP_NET_NODE };
enum { RELATED = sizeof related / sizeof *related };

/* Relations hold between right answers, and are told where they do not; the greatest error within the bound is sought. */
/* One case in 1000. */
verdict prop_conform_run_relations(gen *g)
{
    const et_hello hello = offer(related, RELATED);
    et_conform_options o = ask_for(related, RELATED);
    bool ok = true;

    o.level = 3;
    for (int k = 0; ok && k < 4; k++) {
        context c = { ET_OP_NET_CLASS, k == 1 ? 1 : 0, k == 2, 0, SIZE_MAX, ET_OK };
        et_peer *peer = wrap(&c, &hello);
        et_message message;
        et_conform_report r;
        size_t told = 0;
        o.cases = k == 3 ? 30 : 0;
        o.findings = 5;
        ok = gen_check(g, peer && et_conform_run(&r, peer, &o, NULL, &message) == ET_OK, "run %d: %s", k, message.text);
        for (size_t f = 0; ok && f < r.findings; f++)
            told += r.finding[f].relation != NULL;
        ok = ok && gen_check(g, (told > 0) == (k == 1 || k == 2) && (k == 1 || bad_of(&r) == (k == 2)), "%d: %zu relations told, %zu faults", k, told,
                             bad_of(&r));
        ok = ok && gen_check(g, r.worst[ET_OP_GREVILLE] > 0 && r.worst[ET_OP_GREVILLE] <= 1, "the greatest error of a right answer");
        et_conform_free(&r);
        et_peer_stop(peer);
    }
    return ok ? PASS : FAIL;
}

/* Wherever an answer fails, and wherever the run is stopped, it ends with that status, and with what is known. */
/* One case in 1000. */
verdict prop_conform_run_fails(gen *g)
{
    static const et_request_op ops[] = { ET_OP_MULTIPLICITY, ET_OP_NET_CLASS, ET_OP_NET_NODE };
    static const et_status statuses[] = { ET_ENOMEM, ET_EIO, ET_ESTOPPED };
    const et_hello hello = offer(ops, 3);
    et_conform_options o = ask_for(ops, 3);
    char folder[64];
    bool ok = fill(g, folder, 0, PAGES - 1);

    o.level = 3;
    o.cases = 40;
    o.vectors = folder;
    o.findings = 1;
    for (size_t most = 0, done = 0; ok && done < 2; most += 1 + most / 2) {
        for (size_t k = 0; ok && k < 4; k++) {
            context c = { k % 2 ? ET_OP_MULTIPLICITY : ET_OPS, k % 2 ? 1 : 0, 0, 0, k == 2 ? SIZE_MAX : most, statuses[k % 3] };
            patience p = { 0, k == 2 ? most : SIZE_MAX };
            const et_task task = { step, &p };
            et_peer *peer = wrap(&c, &hello);
            et_message message;
            et_conform_report r;
            const et_status status = et_conform_run(&r, peer, &o, &task, &message);
            done += status == ET_OK;
            ok = gen_check(g, status == ET_OK || (status == statuses[k % 3] && message.text[0]), "%zu calls: status %d: %s", most, (int)status,
                           message.text);
            ok = ok && gen_check(g, k % 2 || bad_of(&r) <= (status == ET_EIO), "%zu faults of a right program", bad_of(&r));
            et_conform_free(&r);
            et_peer_stop(peer);
        }
    }
    empty(folder);
    return ok ? PASS : FAIL;
}

/* ---- programs ---- */

#define HELLO "0 ok protocol=1 name=sh version=1 ops=net_counts,net_class,net_node,span,multiplicity"

/* Judged; 0 where the machine is too busy for the time limit. */
static int judged(gen *g, et_conform_report *r, et_status *status, const char *command, double timeout, const et_conform_options *o)
{
    const et_peer_program program = { command, timeout, NULL, NULL, NULL };
    et_message message = { "" };
    et_asked how = ET_ASKED_REPLY;
    et_peer *peer = NULL;

    memset(r, 0, sizeof *r);
    *status = et_peer_start(&peer, &how, &program, &message);
    if (*status == ET_EFORMAT && how == ET_ASKED_TIMEOUT)
        return 0;
    if (!gen_check(g, *status == ET_OK, "%s: %s", command, message.text))
        return 1;
    *status = et_conform_run(r, peer, o, NULL, &message);
    et_peer_stop(peer);
    return gen_check(g, *status == ET_OK || message.text[0], "a failure is said");
}

static const et_request_op five[] = { ET_OP_SPAN, ET_OP_MULTIPLICITY, ET_OP_NET_COUNTS, ET_OP_NET_CLASS, ET_OP_NET_NODE };

/* Three timeouts end an operation, twelve everything; of the faults a few are made small. */
/* One case in 1000. */
verdict prop_conform_run_hangs(gen *g)
{
    static const char command[] = "read l; echo '" HELLO "'; read l; sleep 30";
    et_conform_options o = ask_for(five, 5);
    et_conform_report r;
    et_status status = ET_OK;
    bool ok = true;

    o.findings = 0;
    if (judged(g, &r, &status, command, 0.1, &o))
        ok = status == ET_EIO || gen_check(g, count_of(&r, ET_OP_NET_COUNTS, ET_VERDICT_TIMEOUT) <= 3 && bad_of(&r) == 12 && r.asked == 12 && r.skipped > 100,
                                           "%zu asked, %zu skipped, %zu faults", r.asked, r.skipped, bad_of(&r));
    et_conform_free(&r);
    o = ask_for(five, 4);
    o.findings = 1;
    if (ok && judged(g, &r, &status, command, 0.1, &o)) {
        size_t shrunk = 0;
        for (size_t k = 0; k < r.findings; k++)
            shrunk += r.finding[k].shrunk != NULL;
        ok = status == ET_EIO || gen_check(g, r.findings == 4 && shrunk >= 2 && shrunk < 4, "%zu faults, %zu of them made small", r.findings, shrunk);
    }
    et_conform_free(&r);
    return ok ? PASS : FAIL;
}

/* One case in 1000. */
verdict prop_conform_run_crashes(gen *g)
{
    et_conform_options o = ask_for(five + 2, 1);
    et_conform_report r;
    et_status status = ET_OK;
    bool ok = gen_check(g, judged(g, &r, &status, "read l; echo '" HELLO "'; read l; exit 3", 60, &o) && status == ET_OK, "judged");

    ok = ok && gen_check(g, count_of(&r, ET_OP_NET_COUNTS, ET_VERDICT_CRASH) == 8 && bad_of(&r) == 8 && r.skipped > 0 && r.findings > 0, "%zu crashes", bad_of(&r));
    ok = ok && gen_check(g, !r.finding[0].reply && r.finding[0].shrunk && !r.finding[0].shrunk_reply, "there is no reply to show");
    et_conform_free(&r);
    return ok ? PASS : FAIL;
}

/* Right until the fortieth request of a process, which is asked again in the first block: a crash or rubbish there; a program that comes back with another
 * hello; one that does not come back, at a first question or a second. */
/* One case in 1000. */
verdict prop_conform_run_comes_back(gen *g)
{
#define UNTIL(n, then) "n=0; while read id rest; do n=$((n + 1)); if [ $n -gt " n " ]; then " then "; fi; echo \"$id refused so\"; done"
    static const struct { const char *command; et_status status; const char *says; et_verdict verdict; } all[] = {
        { "read l; echo '" HELLO "'; " UNTIL("40", "exit 1"), ET_OK, "asked again", ET_VERDICT_NONDETERMINISTIC },
        { "read l; echo '" HELLO "'; " UNTIL("40", "echo so"), ET_OK, "so", ET_VERDICT_WRONG },
        { "read l; echo '" HELLO "'; " UNTIL("40", "echo \"$id ok 1\"; continue"), ET_OK, "the reply is another", ET_VERDICT_NONDETERMINISTIC },
        { "read l; echo \"" HELLO " degree=$$\"; " UNTIL("3", "exit 1"), ET_OK, "hello was another", ET_VERDICT_NONDETERMINISTIC },
        { "[ -e %s ] && exit 3; : > %s; read l; echo '" HELLO "'; " UNTIL("2", "exit 1"), ET_EIO, "exit code 1", ET_VERDICT_CRASH },
        { "[ -e %s ] && exit 3; : > %s; read l; echo '" HELLO "'; " UNTIL("32", "exit 1"), ET_EIO, "asked again", ET_VERDICT_NONDETERMINISTIC },
    };
    const et_conform_options options = ask_for(five + 2, 1);
    bool ok = true;

    for (size_t k = 0; ok && k < sizeof all / sizeof *all; k++) {
        char path[] = "/tmp/etalon-conform-XXXXXX", command[600];
        et_conform_report r;
        et_status status = ET_OK;
        const int fd = mkstemp(path);
        bool found = false;
        close(fd);
        unlink(path);
        if (strstr(all[k].command, "%s"))
            snprintf(command, sizeof command, "[ -e %s ] && exit 3; : > %s; %s", path, path, strstr(all[k].command, "read l"));
        else
            snprintf(command, sizeof command, "%s", all[k].command);
        ok = gen_check(g, judged(g, &r, &status, command, 60, &options) && status == all[k].status, "%s: status %d", command, (int)status);
        for (size_t f = 0; ok && f < r.findings; f++)
            found = found || (r.finding[f].judgement.verdict == all[k].verdict && strstr(r.finding[f].judgement.text, all[k].says));
        ok = ok && gen_check(g, found, "%s: '%s' is not told", command, all[k].says);
        et_conform_free(&r);
        unlink(path);
    }
    return ok ? PASS : FAIL;
}

/* A program that ends, or ends for good, when relations are asked. */
/* One case in 1000. */
verdict prop_conform_run_relations_end(gen *g)
{
    et_conform_options o = ask_for(five + 3, 2);
    bool ok = true;

    o.level = 3;
    o.cases = 0;
    o.findings = 0;
    for (int k = 0; ok && k < 3; k++) {
        char path[] = "/tmp/etalon-conform-XXXXXX", command[600];
        et_conform_report r;
        et_status status = ET_OK;
        const int fd = mkstemp(path);
        close(fd);
        unlink(path);
        snprintf(command, sizeof command, "%s %s ] && exit 3; : > %s; read l; echo '" HELLO "'; " UNTIL("%s", "exit 1"), k == 1 ? "[ -e" : "[ x =", path, path,
                 k == 2 ? "0" : "160");
        ok = gen_check(g, judged(g, &r, &status, command, 60, &o) && status == (k == 1 ? ET_EIO : ET_OK) && r.asked > 8 - (size_t)(k == 2), "%s: status %d, %zu asked",
                       command, (int)status, r.asked);
        et_conform_free(&r);
        unlink(path);
    }
    return ok ? PASS : FAIL;
}
