/* conform: any implementation is judged (docs/conformance.md). */
#include "cli/conform.h"
#include "etalon/io/file.h"
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef struct {
    const char *adapter, *ops, *vectors, *junit, *baseline, *baseline_write, *trace;
    size_t level, cases, findings;
    double timeout;
} choices;
enum { OWN = 11 };

static et_peer *volatile current;         /* for the second interruption, which ends at once */

static void kill_current(void)
{
    et_peer_kill(current);
}

static et_status stop_asked(void *context, size_t done, size_t total)
{
    (void)context;
    (void)done;
    (void)total;
    return cli_stopped() ? ET_ESTOPPED : ET_OK;
}

/* ---- options ---- */

static const char *op_name(size_t k)
{
    return k < ET_OPS ? et_request_name((et_request_op)k) : NULL;
}

static et_status choose_ops(et_conform_options *o, const char *text, et_message *message)
{
    size_t chosen[ET_OPS], n;

    if (!text)
        return ET_OK;
    const et_status status = cli_list(chosen, &n, ET_OPS, text, op_name, "ops", message);
    if (status != ET_OK)
        return status;
    memset(o->op, 0, sizeof o->op);
    for (size_t k = 0; k < n; k++)
        o->op[chosen[k]] = 1;
    return ET_OK;
}

/* The vectors installed beside this program, else those of the source tree in which we stand. */
static const char *find_vectors(char path[1200])
{
    char program[1024];
    const ssize_t n = readlink("/proc/self/exe", program, sizeof program - 1);
    char *slash = NULL;

    if (n > 0) {
        program[n] = '\0';
        slash = strrchr(program, '/');
    }
    if (slash) {
        *slash = '\0';
        snprintf(path, 1200, "%s/../share/etalon/conformance", program);
        if (access(path, R_OK) == 0)
            return path;
    }
    return "golden/conformance";
}

static et_status settle(et_conform_options *o, const choices *c, const cli_run *run, char path[1200], et_message *message)
{
    const char *const files[] = { c->junit, c->trace, c->baseline_write };
    const char *const others[] = { c->junit, c->trace, c->baseline };

    if (!c->adapter)
        return et_status_fail(message, ET_EINVAL, "--adapter is missing: the command to judge; see etalon conform --help");
    if (c->level > 3)
        return et_status_fail(message, ET_EINVAL, "--level is 0, 1, 2 or 3");
    if (!(c->timeout > 0 && c->timeout <= 1e6))
        return et_status_fail(message, ET_EINVAL, "--timeout wants seconds above 0");
    if (run->json && ((c->junit && strcmp(c->junit, "-") == 0) || (c->trace && strcmp(c->trace, "-") == 0)))
        return et_status_fail(message, ET_EINVAL, "--json has standard output for itself");
    o->level = (unsigned)c->level;
    o->seed = run->seed;
    o->cases = c->cases;
    o->findings = c->findings;
    o->vectors = c->vectors ? c->vectors : find_vectors(path);
    et_status status = cli_distinct(files, 3, message);
    if (status == ET_OK)
        status = cli_distinct(others, 3, message);
    return status == ET_OK ? choose_ops(o, c->ops, message) : status;
}

/* ---- the conversation, for --trace ---- */

typedef struct { FILE *out; char last; int within; } conversation;

static void trace(void *context, char what, const char *text, size_t length)
{
    conversation *t = context;

    if (t->within && what != t->last) {
        fputc('\n', t->out);
        t->within = 0;
    }
    t->last = what;
    for (size_t k = 0; k < length; k++) {
        const unsigned char c = (unsigned char)text[k];
        if (!t->within)
            fprintf(t->out, "%c ", what);
        t->within = c != '\n';
        if (c == '\n' || (c >= ' ' && c < 0x7f))
            fputc(c, t->out);
        else
            fprintf(t->out, "\\x%02x", (unsigned)c);
    }
    if (what == '!') {
        fputc('\n', t->out);
        t->within = 0;
    }
}

/* ---- the run ---- */

static et_status run_peer(conform_result *r, et_peer *peer, cli_run *run, et_message *message)
{
    size_t n = 0;

    r->hello = *et_peer_hello(peer);
    r->greeted = 1;
    for (int op = 0; op < ET_OPS; op++)
        n += r->options.op[op] && r->hello.op[op];
    if (n == 0)
        return et_status_fail(message, ET_EFORMAT, "%s offers none of the operations asked for", r->adapter);
    if (r->hello.unknown > 0)
        cli_say(run, "etalon conform: hello offers %zu operations that are not known here", r->hello.unknown);
    const et_task task = cli_task(run, "asking");
    const et_status status = et_conform_run(&r->report, peer, &r->options, &task, message);
    cli_task_end(run);
    return status;
}

/* Started, greeted, asked.  ET_OK, too, where there is no greeting: r->greeted says so. */
static et_status run_program(conform_result *r, const choices *c, FILE *talk, cli_run *run, et_message *message)
{
    static const et_verdict verdicts[] = { ET_VERDICT_WRONG, ET_VERDICT_CRASH, ET_VERDICT_TIMEOUT, ET_VERDICT_WRONG };
    const et_task stop = { stop_asked, NULL };
    conversation t = { talk, 0, 0 };
    const et_peer_program program = { c->adapter, c->timeout, talk ? trace : NULL, &t, &stop };
    et_peer *peer;
    et_asked how;
    et_status status = et_peer_start(&peer, &how, &program, message);

    if (status == ET_EFORMAT) {
        r->text = *message;
        r->greeting = verdicts[how];
        return ET_OK;
    }
    if (status != ET_OK)
        return status;
    current = peer;
    cli_on_end(kill_current);
    status = run_peer(r, peer, run, message);
    cli_on_end(NULL);
    current = NULL;
    et_peer_stop(peer);
    return status;
}

/* ---- what comes of it ---- */

static et_status write_files(const conform_result *r, const choices *c, et_message *message)
{
    et_status status = c->junit ? conform_write_junit(c->junit, r, message) : ET_OK;

    if (status == ET_OK && c->baseline_write && !r->stopped && r->greeted) {           /* what was not asked is not known */
        json_t *o = json_pack("{s:s, s:o}", "format", "etalon-conformance-baseline", "known", conform_bad_list(r));
        status = cli_write_json(c->baseline_write, o, message);
        json_decref(o);
    }
    return status;
}

static et_status show(const conform_result *r, const cli_run *run, et_message *message)
{
    if (run->json) {
        json_t *o = conform_json(r);
        const et_status status = cli_print(o, message);
        json_decref(o);
        return status;
    }
    if (!run->quiet)
        conform_print(stdout, r);
    return fflush(stdout) == 0 ? ET_OK : et_status_fail(message, ET_EIO, "cannot write to standard output");
}

/* Files, report, and what the run is worth: `ended` says how it went. */
static et_status conclude(conform_result *r, const choices *c, const cli_run *run, et_status ended, et_message *message)
{
    et_message why = *message;
    size_t requests;
    const size_t fresh = conform_new(r, &requests);

    r->stopped = ended == ET_ESTOPPED;
    et_status status = write_files(r, c, message);
    if (status == ET_OK && !r->greeted && !run->json)
        return et_status_fail(message, ET_EFORMAT, "%s: %s: %.900s", r->adapter, et_judge_name(r->greeting), r->text.text);
    if (status == ET_OK)
        status = show(r, run, message);
    if (status != ET_OK)
        return status;
    if (ended == ET_ESTOPPED)
        return et_status_fail(message, ended, "interrupted");
    /* A program that does not start any more has been counted as a crash. */
    if (ended == ET_EIO)
        return et_status_fail(message, fresh ? ET_EDIFFER : ET_EIO, "%.900s", why.text);
    if (fresh > 0)
        return et_status_fail(message, ET_EDIFFER, "%zu answers of %zu kinds are not right%s", requests, fresh,
                              r->baseline ? " and not in the baseline" : "");
    return ET_OK;
}

static et_status judge_it(conform_result *r, const choices *c, cli_run *run, et_message *message)
{
    et_file talk = { NULL, NULL, NULL, NULL };
    et_status status = c->baseline ? conform_read_baseline(&r->baseline, c->baseline, message) : ET_OK;

    if (status == ET_OK && c->trace)
        status = et_file_create(&talk, c->trace, message);
    if (status != ET_OK)
        return status;
    status = run_program(r, c, talk.stream, run, message);
    if (talk.stream) {
        et_message unwritten;
        if (et_file_commit(&talk, &unwritten) != ET_OK && status == ET_OK)
            return et_status_fail(message, ET_EIO, "%s", unwritten.text);
    }
    const int asked = r->greeted && r->report.asked > 0;
    if (status == ET_OK || status == ET_ESTOPPED || (status == ET_EIO && asked))
        return conclude(r, c, run, status, message);
    return status;
}

static void table(cli_option options[OWN], choices *c)
{
    const cli_option own[OWN] = {
        { "adapter", 0, CLI_TEXT, &c->adapter, "COMMAND", "the program to judge, run by the shell", NULL },
        { "level", 0, CLI_SIZE, &c->level, "0..3", "how much is asked (default 0: a few of everything)", NULL },
        { "ops", 0, CLI_TEXT, &c->ops, "WORDS", "operations, separated by commas (default all)", NULL },
        { "cases", 0, CLI_SIZE, &c->cases, "N", "cases of level 2 (default 10000)", NULL },
        { "timeout", 0, CLI_REAL, &c->timeout, "S", "seconds for a reply (default 5)", NULL },
        { "vectors", 0, CLI_TEXT, &c->vectors, "DIR", "the frozen vectors of level 1 (default: those installed)", NULL },
        { "findings", 0, CLI_SIZE, &c->findings, "N", "faults told of each operation and verdict (default 3)", NULL },
        { "junit", 0, CLI_TEXT, &c->junit, "FILE", "also write JUnit's XML", NULL },
        { "baseline", 0, CLI_TEXT, &c->baseline, "FILE", "what is known is no failure: an earlier --json or --baseline-write", NULL },
        { "baseline-write", 0, CLI_TEXT, &c->baseline_write, "FILE", "write what is wrong as a baseline", NULL },
        { "trace", 0, CLI_TEXT, &c->trace, "FILE", "write the whole conversation", NULL },
    };
    memcpy(options, own, sizeof own);
}

et_status cli_conform(int argc, char **argv, et_message *message)
{
    choices c = { NULL, NULL, NULL, NULL, NULL, NULL, NULL, 0, 10000, 3, 5 };
    cli_run run = cli_run_defaults();
    const char *positional[1];
    char path[1200];
    size_t n;
    cli_option options[OWN + CLI_COMMON];
    conform_result r;
    const cli_help help = { "conform", "etalon conform --adapter COMMAND [options]",
                            "Asks a program that speaks the conformance protocol (docs/conformance.md), judges each answer against the exact result,\n"
                            "and tells each fault as the smallest request that shows it.",
                            "  etalon conform --adapter ./my_adapter\n"
                            "  etalon conform --adapter 'python3 my_adapter.py' --level 2 --ops curve_point,curve_insert --cases 5000\n"
                            "  etalon conform --adapter ./my_adapter --level 1 --junit out.xml --baseline known.json\n", 0, 0 };

    table(options, &c);
    cli_common(options + OWN, &run);
    et_status status = cli_parse(positional, &n, argc, argv, options, OWN + CLI_COMMON, &help, message);
    if (status != ET_OK || run.help)
        return status;
    memset(&r, 0, sizeof r);
    r.options = et_conform_defaults();
    r.adapter = c.adapter;
    status = settle(&r.options, &c, &run, path, message);
    if (status == ET_OK)
        status = judge_it(&r, &c, &run, message);
    et_conform_free(&r.report);
    json_decref(r.baseline);
    return status;
}
