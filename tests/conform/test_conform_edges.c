/* conform/conform: runs that are stopped anywhere, faults told once of each kind, what is undecided, programs that break within a block. */
#include "etalon/conform/answer.h"
#include "etalon/conform/conform.h"
#include "conform/report.h"
#include "gen.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

verdict prop_conform_run_not_offered(gen *g);
verdict prop_conform_run_stopped_anywhere(gen *g);
verdict prop_conform_run_told_once(gen *g);
verdict prop_conform_run_undecided(gen *g);
verdict prop_conform_run_breaks(gen *g);

/* Answers rightly, but its first number is one too high where the last number of the request is `from` or more. */
typedef struct { double from; size_t calls; } context;

static et_status answer(void *at, et_reply *reply, const et_request *request)
{
    context *c = at;
    size_t last = 0;
    const et_status status = et_answer_fast(reply, request);

    c->calls++;
    while (et_request_argument(request->op, last))
        last++;
    while (last > 0 && et_request_argument(request->op, last - 1)->kind != ET_ARG_REAL)
        last--;
    if (status == ET_OK && last > 0 && reply->count > 0 && request->arg[last - 1].x[0] >= c->from)
        reply->x[0] += 1;
    return status;
}

/* It offers these operations. */
static et_peer *wrap(context *c, const et_request_op *ops, size_t n)
{
    et_peer_table table = { et_answer_hello(0), answer, c };
    et_peer *peer = NULL;

    memset(table.hello.op, 0, sizeof table.hello.op);
    for (size_t k = 0; k < n; k++)
        table.hello.op[ops[k]] = 1;
    return et_peer_wrap(&peer, &table) == ET_OK ? peer : NULL;
}

static et_conform_options ask_for(const et_request_op *ops, size_t n, unsigned level)
{
    et_conform_options o = et_conform_defaults();

    memset(o.op, 0, sizeof o.op);
    for (size_t k = 0; k < n; k++)
        o.op[ops[k]] = 1;
    o.level = level;
    o.cases = 0;
    return o;
}

/* A folder with schema.json and the vectors of one operation. */
static bool fill(gen *g, char folder[64], const char *operation, const char *vectors)
{
    bool ok = gen_check(g, mkdtemp(strcpy(folder, "/tmp/etalon-vectors-XXXXXX")) != NULL, "a folder is made");

    for (int k = 0; ok && k < 2; k++) {
        char path[128];
        snprintf(path, sizeof path, "%s/%s.json", folder, k ? operation : "schema");
        FILE *file = fopen(path, "w");
        ok = gen_check(g, file != NULL, "%s is written", path);
        if (ok && k)
            fprintf(file, "{\"format\": \"etalon-conformance\", \"version\": 1, \"operation\": \"%s\", \"vectors\": [%s]}", operation, vectors);
        else if (ok)
            fputs("{}", file);
        ok = ok && fclose(file) == 0;
    }
    return ok;
}

static void empty(const char *folder, const char *operation)
{
    char path[128];

    snprintf(path, sizeof path, "%s/schema.json", folder);
    unlink(path);
    snprintf(path, sizeof path, "%s/%s.json", folder, operation);
    unlink(path);
    rmdir(folder);
}

/* Nothing that is wanted is offered: nothing is asked, at any level, and every kind of case counts as unsupported. */
/* One case in 100. */
verdict prop_conform_run_not_offered(gen *g)
{
    static const et_request_op ops[] = { ET_OP_CURVE_NEAREST }, others[] = { ET_OP_SPAN };
    et_conform_options o = ask_for(ops, 1, (unsigned)gen_upto(g, 3));
    context c = { 1e300, 0 };
    et_peer *peer = wrap(&c, others, 1);
    et_conform_report r;

    o.cases = 20;
    bool ok = peer && gen_check(g, et_conform_run(&r, peer, &o, NULL, NULL) == ET_OK, "run");
    ok = ok && gen_check(g, r.asked == 0 && c.calls == 0 && bad_of(&r) == 0 && r.findings == 0, "%zu asked", c.calls);
    ok = ok && gen_check(g, count_of(&r, ET_OP_CURVE_NEAREST, ET_VERDICT_UNSUPPORTED) > 0, "not counted as unsupported");
    et_conform_free(&r);
    et_peer_stop(peer);
    return ok ? PASS : FAIL;
}

/* Among more frozen vectors than are asked at once, while a fault is made small, or on the way to worse cases: a run that is stopped says so, and
 * what it tells are the faults of the whole run, or some of them. */
/* One case in 1000. */
verdict prop_conform_run_stopped_anywhere(gen *g)
{
    static const et_request_op ops[] = { ET_OP_GREVILLE, ET_OP_MULTIPLICITY };
    static const char vector[] = "{\"id\": \"multiplicity/plain/%zu\", \"category\": \"plain\", \"validity\": \"valid\", \"request\": \"2 0 1 %zu\", "
                                 "\"want\": [\"0\"], \"bound\": [\"0x0p+0\"], \"condition\": \"0x1p+0\"}";
    enum { VECTORS = 40, EACH = 200 };
    char folder[64], text[VECTORS * EACH] = "";
    et_conform_options o;
    size_t whole = SIZE_MAX, steps[2] = { 0, 0 };
    bool ok;

    for (size_t k = 0, n = 0; k < VECTORS; k++) {
        n += (size_t)snprintf(text + n, sizeof text - n, vector, k + 1, k + 2);
        n += (size_t)snprintf(text + n, sizeof text - n, "%s", k + 1 < VECTORS ? ", " : "");
    }
    ok = fill(g, folder, "multiplicity", text);
    for (unsigned level = 1; ok && level <= 3; level += 2)
        for (size_t k = 0; ok && k <= 40; k++) {
            patience p = { 0, k == 0 ? SIZE_MAX : level == 1 ? k * steps[0] / 41 : steps[1] - 2 * k };
            const et_task task = { step, &p };
            context c = { level == 1 ? 20 : 1e300, 0 };
            et_peer *peer = wrap(&c, ops + (level == 1), level == 1 ? 1 : 2);
            et_message message = { "" };
            et_conform_report r;
            o = ask_for(ops + (level == 1), level == 1 ? 1 : 2, level);
            o.vectors = folder;
            o.findings = 1;
            const et_status status = et_conform_run(&r, peer, &o, &task, &message);
            whole = k == 0 ? bad_of(&r) : whole;
            steps[level / 2] = k == 0 ? p.calls : steps[level / 2];
            ok = gen_check(g, status == (k == 0 ? ET_OK : ET_ESTOPPED) && (k == 0 || message.text[0]), "level %u, %zu steps: status %d: %s", level,
                           p.most, (int)status, message.text);
            ok = ok && gen_check(g, bad_of(&r) <= whole && (level == 1) == (whole > 0), "%zu faults of %zu", bad_of(&r), whole);
            et_conform_free(&r);
            et_peer_stop(peer);
        }
    empty(folder, "multiplicity");
    return ok ? PASS : FAIL;
}

#define TWICE(id, more) \
    "{\"id\": \"" id "\", \"category\": \"plain\", \"validity\": \"valid\", \"request\": \"1 4 0 0 1024 1024 1000\", \"want\": [\"1\"], " \
    "\"bound\": [\"0x0p+0\"], \"condition\": \"0x1p+0\"" more "}"

/* One kind of fault with an issue and without, and in a relation: three to be told, each once. */
/* One case in 1000. */
verdict prop_conform_run_told_once(gen *g)
{
    static const et_request_op ops[] = { ET_OP_SPAN, ET_OP_MULTIPLICITY };
    et_conform_options o = ask_for(ops, 2, 3);
    char folder[64];
    bool ok = fill(g, folder, "span", TWICE("a", ", \"issue\": \"https://a\"") ", " TWICE("b", "") ", "
                   TWICE("c", ", \"issue\": \"https://a\"") ", " TWICE("d", ""));

    o.vectors = folder;
    o.findings = 100;
    for (int k = 0; ok && k < 2; k++) {
        context c = { k ? 0.25 : 1000, 0 };          /* cases drawn are below 1000, but for extreme scales */
        et_peer *peer = wrap(&c, ops, 2);
        et_conform_report r;
        size_t issues = 0, vectors = 0, relations = 0, plain = 0;
        ok = gen_check(g, et_conform_run(&r, peer, &o, NULL, NULL) == ET_OK, "run %d", k);
        for (size_t f = 0; ok && f < r.findings; f++)
            if (r.finding[f].category == ET_CATEGORY_PLAIN && r.finding[f].op == ET_OP_SPAN && r.finding[f].judgement.verdict == ET_VERDICT_WRONG) {
                issues += r.finding[f].issue != NULL;
                vectors += r.finding[f].vector && !r.finding[f].issue;
                relations += r.finding[f].relation != NULL;
                plain += !r.finding[f].vector && !r.finding[f].relation;
            }
        ok = ok && gen_check(g, issues == 1 && vectors + plain == 1 && (k ? plain == 1 && relations == 1 : vectors == 1 && relations == 0),
                             "%d: %zu with the issue, %zu other vectors, %zu relations, %zu drawn", k, issues, vectors, relations, plain);
        et_conform_free(&r);
        et_peer_stop(peer);
    }
    empty(folder, "span");
    return ok ? PASS : FAIL;
}

static et_status nothing_right(void *at, et_reply *reply, const et_request *request)
{
    static const double seven[8] = { 7, 7, 7, 7, 7, 7, 7, 7 };
    (void)at;
    (void)request;
    return et_reply_put(reply, seven, 8);
}

/* A frozen vector says what the exact layer does not find out: a wrong reply is told, but nothing smaller is looked for. */
/* One case in 1000. */
verdict prop_conform_run_undecided(gen *g)
{
    static const et_request_op ops[] = { ET_OP_PARAMETERS_GRID };
    static const char vector[] = "{\"id\": \"undecided\", \"category\": \"plain\", \"validity\": \"valid\", \"request\": "
        "\"chord 4 4 16 0 0 0 0 0 0 -7 0 0 0 0 0 3 0 0 3 0 0 0x1p+53 0 0 0 0 0 3 4 0 4 1 0 0x1.bffffffffffffp+55 0 0 0 1 0 3 -3 7 4 1 0 "
        "0x1.bffffffffffffp+55 1 0 0 2 0\", "
        "\"want\": [\"0\", \"0x1p-2\", \"0x1p-1\", \"1\", \"0\", \"0x1p-2\", \"0x1p-1\", \"1\"], \"bound\": [\"0\", \"0x1p-10\", "
        "\"0x1p-10\", \"0\", \"0\", \"0x1p-10\", \"0x1p-10\", \"0\"], \"condition\": \"0x1p+0\", \"issue\": \"https://a\"}";
    et_peer_table table = { et_answer_hello(0), nothing_right, NULL };
    et_conform_options o = ask_for(ops, 1, 1);
    et_message message = { "" };
    et_peer *peer = NULL;
    et_conform_report r;
    char folder[64];
    size_t told = 0;
    bool ok = fill(g, folder, "parameters_grid", vector);

    memset(table.hello.op, 0, sizeof table.hello.op);
    table.hello.op[ET_OP_PARAMETERS_GRID] = 1;
    o.vectors = folder;
    o.findings = 100;
    ok = ok && gen_check(g, et_peer_wrap(&peer, &table) == ET_OK && et_conform_run(&r, peer, &o, NULL, &message) == ET_OK, "run: %s", message.text);
    for (size_t f = 0; ok && f < r.findings; f++)
        if (r.finding[f].vector) {
            told++;
            ok = gen_check(g, !r.finding[f].shrunk && r.finding[f].reply && r.finding[f].judgement.verdict == ET_VERDICT_WRONG, "told otherwise");
        }
    ok = ok && gen_check(g, told == 1 && r.skipped == 0, "told %zu times", told);
    et_conform_free(&r);
    et_peer_stop(peer);
    empty(folder, "parameters_grid");
    return ok ? PASS : FAIL;
}

/* Ten replies, then nothing but crashes: after eight the operation is left out, and what had a reply is not asked again. */
/* One case in 1000. */
verdict prop_conform_run_breaks(gen *g)
{
    static const et_request_op ops[] = { ET_OP_NET_COUNTS };
    et_conform_options o = ask_for(ops, 1, 0);
    char path[] = "/tmp/etalon-conform-XXXXXX", command[600];
    const et_peer_program program = { command, 60, NULL, NULL, NULL };
    et_message message = { "" };
    et_asked how = ET_ASKED_REPLY;
    et_peer *peer = NULL;
    et_conform_report r;
    const int fd = mkstemp(path);

    close(fd);
    unlink(path);
    o.findings = 0;
    snprintf(command, sizeof command, "read l; echo '0 ok protocol=1 name=sh version=1 ops=net_counts'; [ -e %s ] && read l && exit 1; n=0; "
             "while read id rest; do n=$((n + 1)); if [ $n -gt 10 ]; then : > %s; exit 1; fi; echo \"$id refused so\"; done", path, path);
    bool ok = gen_check(g, et_peer_start(&peer, &how, &program, &message) == ET_OK, "%s", message.text);
    if (!ok)
        return FAIL;
    ok = gen_check(g, et_conform_run(&r, peer, &o, NULL, &message) == ET_OK, "%s", message.text);
    const size_t crashes = count_of(&r, ET_OP_NET_COUNTS, ET_VERDICT_CRASH);
    ok = ok && gen_check(g, crashes == 8 && r.asked == 18 && r.skipped > 0, "%zu crashes, %zu asked, %zu skipped", crashes, r.asked, r.skipped);
    ok = ok && gen_check(g, count_of(&r, ET_OP_NET_COUNTS, ET_VERDICT_WRONGLY_REFUSED) + r.refused_rightly == 10, "the replies are judged");
    et_conform_free(&r);
    et_peer_stop(peer);
    unlink(path);
    return ok ? PASS : FAIL;
}
