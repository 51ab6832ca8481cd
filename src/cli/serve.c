/* serve: Etalon as a program under test, and as the reference that anyone can ask (docs/conformance.md). */
#include "cli/cli.h"
#include "etalon/conform/answer.h"
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

/* Bytes of a request's line; what is longer is passed over and refused. */
static const size_t longest = (size_t)1 << 28;

typedef struct { char *text; size_t length, room; int too_long; } input_line;

/* 1: the next line, without its end; 0: there are no more, or reading failed (ferror), or memory did (too_long < 0). */
static int next_line(input_line *line, FILE *in)
{
    int c;

    line->length = 0;
    line->too_long = 0;
    while ((c = getc(in)) != EOF && c != '\n') {
        if (line->length + 1 >= line->room && line->room < longest) {
            const size_t room = line->room ? 2 * line->room : 4096;
            char *more = realloc(line->text, room);
            if (!more) {
                line->too_long = -1;
                return 0;
            }
            line->text = more;
            line->room = room;
        }
        if (line->length + 1 < line->room)
            line->text[line->length++] = (char)c;
        else
            line->too_long = 1;
    }
    if (!line->text || (c == EOF && line->length == 0))
        return c == '\n';
    line->text[line->length] = '\0';
    return 1;
}

/* The number of the request, and *rest behind it; 0 where there is none. */
static int read_id(uint64_t *id, const char **rest, const char *text)
{
    uint64_t n = 0;
    const char *at = text + strspn(text, " \t");
    const char *first = at;

    for (; *at >= '0' && *at <= '9'; at++) {
        n = 10 * n + (uint64_t)(*at - '0');
        if (n > UINT64_C(1) << 53)
            return 0;
    }
    if (at == first || (*at && !strchr(" \t\r", *at)))
        return 0;
    *id = n;
    *rest = at + strspn(at, " \t\r");
    return 1;
}

static void put_limit(FILE *out, const char *key, size_t limit)
{
    if (limit != SIZE_MAX)
        fprintf(out, " %s=%zu", key, limit);
}

static void put_hello(FILE *out, uint64_t id, int exact)
{
    const et_hello hello = et_answer_hello(exact);
    const char *before = "";

    fprintf(out, "%" PRIu64 " ok protocol=1 name=%s version=%s", id, hello.name, hello.version);
    put_limit(out, "degree", hello.degree);
    put_limit(out, "order", hello.order);
    fprintf(out, " rational=%d sides=%s", hello.rational, hello.any ? "any" : "");
    fprintf(out, "%s%s knot_tolerance=0 ops=", hello.left ? hello.any ? ",left" : "left" : "",
            hello.right ? hello.any || hello.left ? ",right" : "right" : "");
    for (int op = 0; op < ET_OPS; op++)
        if (hello.op[op]) {
            fprintf(out, "%s%s", before, et_request_name((et_request_op)op));
            before = ",";
        }
    fputc('\n', out);
}

static void put_reply(FILE *out, uint64_t id, const et_reply *reply)
{
    char *text;

    if (et_reply_print(&text, id, reply) == ET_OK) {
        fprintf(out, "%s\n", text);
        free(text);
    } else {
        fprintf(out, "%" PRIu64 " refused out of memory\n", id);
    }
}

static void answer(FILE *out, uint64_t id, const char *text, int exact)
{
    et_message why = { "" };
    et_request request;
    et_reply reply;

    if (et_request_parse(&request, text, &why) != ET_OK) {
        fprintf(out, "%" PRIu64 " refused %s\n", id, why.text);
        return;
    }
    memset(&reply, 0, sizeof reply);
    if ((exact ? et_answer_exact : et_answer_fast)(&reply, &request) == ET_OK)
        put_reply(out, id, &reply);
    else
        fprintf(out, "%" PRIu64 " refused out of memory\n", id);
    et_reply_free(&reply);
    et_request_free(&request);
}

static void answer_line(FILE *out, const input_line *line, int exact)
{
    const char *rest;
    uint64_t id;

    if (line->too_long || !line->text || strlen(line->text) != line->length || !read_id(&id, &rest, line->text))
        fprintf(out, "0 refused the line %s\n", line->too_long ? "is too long" : "does not begin with the number of a request");
    else if (strncmp(rest, "hello", 5) == 0 && strchr(" \t\r", rest[5])) {
        const char *version = rest + 5 + strspn(rest + 5, " \t\r");
        if (version[0] == '1' && strspn(version + 1, " \t\r") == strlen(version + 1))
            put_hello(out, id, exact);
        else
            fprintf(out, "%" PRIu64 " refused the protocol spoken here is 1\n", id);
    } else {
        answer(out, id, rest, exact);
    }
}

static et_status serve(int exact, et_message *message)
{
    input_line line = { NULL, 0, 0, 0 };
    int written = 1;

    while (written && next_line(&line, stdin)) {
        answer_line(stdout, &line, exact);
        written = fflush(stdout) == 0;
    }
    free(line.text);
    if (line.too_long < 0)
        return et_status_fail(message, ET_ENOMEM, "out of memory");
    if (!written)
        return et_status_fail(message, ET_EIO, "cannot write to standard output: %s", strerror(errno));
    return ferror(stdin) ? et_status_fail(message, ET_EIO, "cannot read standard input") : ET_OK;
}

et_status cli_serve(int argc, char **argv, et_message *message)
{
    cli_run run = cli_run_defaults();
    const char *positional[1];
    size_t n;
    cli_option options[1 + CLI_COMMON] = { { "exact", 0, CLI_FLAG, &run.exact, NULL, "correctly rounded answers, to every operation", NULL } };
    const cli_help help = { "serve", "etalon serve [--exact]",
                            "Answers the requests of the conformance protocol (docs/conformance.md) that come on standard input, one a line.",
                            "  echo '0 hello 1' | etalon serve\n"
                            "  echo '1 basis 1 4 0x0p+0 0x0p+0 0x1p+0 0x1p+0 0x1p-2 any' | etalon serve --exact\n"
                            "  etalon conform --adapter 'etalon serve'\n", 0, 0 };

    cli_common(options + 1, &run);
    const et_status status = cli_parse(positional, &n, argc, argv, options, 1 + CLI_COMMON, &help, message);
    if (status != ET_OK || run.help)
        return status;
    cli_end_at_once();
    return serve(run.exact, message);
}
