/* conform_print: what `etalon conform` tells people. */
#include "cli/conform.h"
#include <math.h>
#include <stdint.h>
#include <string.h>

/* ---- counts ---- */

size_t conform_of(const conform_result *r, et_request_op op, et_verdict verdict)
{
    size_t n = 0;

    for (int c = 0; c < ET_CATEGORIES; c++)
        n += r->report.count[op][c][verdict];
    return n;
}

size_t conform_total(const conform_result *r, et_verdict verdict)
{
    size_t n = !r->greeted && verdict == r->greeting;

    for (int op = 0; op < ET_OPS; op++)
        n += conform_of(r, (et_request_op)op, verdict);
    return n;
}

void conform_key(char key[CONFORM_KEY], et_request_op op, et_category category, et_verdict verdict)
{
    snprintf(key, CONFORM_KEY, "%s/%s/%s", et_request_name(op), et_campaign_name(category), et_judge_name(verdict));
}

int conform_known(const conform_result *r, et_request_op op, et_category category, et_verdict verdict)
{
    char key[CONFORM_KEY];
    const size_t n = r->baseline ? json_array_size(r->baseline) : 0;

    conform_key(key, op, category, verdict);
    for (size_t k = 0; k < n; k++)
        if (strcmp(json_string_value(json_array_get(r->baseline, k)), key) == 0)
            return 1;
    return 0;
}

size_t conform_new(const conform_result *r, size_t *requests)
{
    size_t kinds = !r->greeted;

    *requests = !r->greeted;
    for (int op = 0; op < ET_OPS; op++)
        for (int c = 0; c < ET_CATEGORIES; c++)
            for (int v = 0; v < ET_VERDICTS; v++) {
                const size_t n = r->report.count[op][c][v];
                if (n > 0 && et_judge_bad((et_verdict)v) && !conform_known(r, (et_request_op)op, (et_category)c, (et_verdict)v)) {
                    kinds++;
                    *requests += n;
                }
            }
    return kinds;
}

/* ---- text from outside ---- */

/* Bytes of the character that begins here; 0: none does. */
static size_t character(const unsigned char *s)
{
    const size_t n = s[0] < 0x80 ? 1 : s[0] >= 0xc2 && s[0] < 0xe0 ? 2 : s[0] >= 0xe0 && s[0] < 0xf0 ? 3 : s[0] >= 0xf0 && s[0] < 0xf5 ? 4 : 0;

    if (n == 1)
        return s[0] >= ' ' && s[0] != 0x7f;
    for (size_t k = 1; k < n; k++)
        if ((s[k] & 0xc0) != 0x80)
            return 0;
    /* Overlong forms, surrogates, what is beyond the last character, C1 controls, and U+FFFE and U+FFFF, which XML does not have. */
    if ((s[0] == 0xc2 && s[1] < 0xa0) || (s[0] == 0xe0 && s[1] < 0xa0) || (s[0] == 0xed && s[1] >= 0xa0) || (s[0] == 0xf0 && s[1] < 0x90)
        || (s[0] == 0xf4 && s[1] >= 0x90) || (s[0] == 0xef && s[1] == 0xbf && s[2] >= 0xbe))
        return 0;
    return n;
}

const char *conform_clean(char clean[CONFORM_TEXT], const char *text)
{
    size_t length = 0;

    while (*text && length + 5 < CONFORM_TEXT) {
        const size_t n = character((const unsigned char *)text);
        if (n == 0) {
            clean[length++] = '?';
            text++;
            continue;
        }
        memcpy(clean + length, text, n);
        length += n;
        text += n;
    }
    clean[length] = '\0';
    return clean;
}

/* ---- the table ---- */

enum { NAME_WIDTH = 18 };

static void put_row(FILE *out, const conform_result *r, int op, const int *shown)
{
    fprintf(out, "%-*s", (int)NAME_WIDTH, op < ET_OPS ? et_request_name((et_request_op)op) : "all");
    for (int v = 0; v < ET_VERDICTS; v++)
        if (shown[v])
            fprintf(out, "  %*zu", (int)strlen(et_judge_name((et_verdict)v)),
                    op < ET_OPS ? conform_of(r, (et_request_op)op, (et_verdict)v) : conform_total(r, (et_verdict)v));
    if (op < ET_OPS && r->report.worst[op] > 0)
        fprintf(out, "  %17.3g", r->report.worst[op]);
    fputc('\n', out);
}

static int asked(const conform_result *r, int op)
{
    for (int v = 0; v < ET_VERDICTS; v++)
        if (v != ET_VERDICT_UNSUPPORTED && conform_of(r, (et_request_op)op, (et_verdict)v) > 0)
            return 1;
    return 0;
}

/* Columns of zeros are left out, and operations of which nothing was judged are named in one line. */
static void put_table(FILE *out, const conform_result *r)
{
    const char *before = "not offered: ";
    int shown[ET_VERDICTS];

    fprintf(out, "%-*s", (int)NAME_WIDTH, "operation");
    for (int v = 0; v < ET_VERDICTS; v++) {
        shown[v] = conform_total(r, (et_verdict)v) > 0;
        if (shown[v])
            fprintf(out, "  %s", et_judge_name((et_verdict)v));
    }
    fprintf(out, "  worst error/bound\n");
    for (int op = 0; op < ET_OPS; op++)
        if (asked(r, op))
            put_row(out, r, op, shown);
    put_row(out, r, ET_OPS, shown);
    for (int op = 0; op < ET_OPS; op++)
        if (r->options.op[op] && !r->hello.op[op]) {
            fprintf(out, "%s%s", before, et_request_name((et_request_op)op));
            before = ", ";
        }
    fputs(before[0] == ',' ? "\n" : "", out);
}

/* ---- findings ---- */

static void put_number(FILE *out, const char *what, double x)
{
    fprintf(out, "    %-6s %a (%.17g)\n", what, x, x);
}

/* Of several commands the first alone would be asked. */
int conform_compound(const char *adapter)
{
    return strpbrk(adapter, "|&;\n") != NULL;
}

static void put_judgement(FILE *out, const et_judgement *j)
{
    char clean[CONFORM_TEXT];

    if (j->text[0])
        fprintf(out, "    %s\n", conform_clean(clean, j->text));
    if (j->at == SIZE_MAX)
        return;
    put_number(out, "got", j->got);
    put_number(out, "want", j->want);
    put_number(out, "bound", j->bound);
    if (j->ratio > 0)
        fprintf(out, "    error/bound %.3g\n", j->ratio);
}

static void put_finding(FILE *out, const conform_result *r, const et_conform_finding *f, size_t number)
{
    char clean[CONFORM_TEXT];
    const char *request = f->shrunk ? f->shrunk : f->request, *reply = f->shrunk ? f->shrunk_reply : f->reply;

    fprintf(out, "\n%zu. %s, %s: %s%s\n", number, et_request_name(f->op), et_campaign_name(f->category), et_judge_name(f->judgement.verdict),
            conform_known(r, f->op, f->category, f->judgement.verdict) ? " (known)" : "");
    if (f->relation)
        fprintf(out, "    %s\n", f->relation);
    put_judgement(out, f->shrunk ? &f->shrunk_judgement : &f->judgement);
    if (reply)
        fprintf(out, "    reply: %s\n", conform_clean(clean, reply));
    if (f->vector)
        fprintf(out, "    vector: %s\n", f->vector);
    if (f->issue)
        fprintf(out, "    like %s\n", f->issue);
    fprintf(out, conform_compound(r->adapter) ? "    echo '1 %s' | (%s)\n" : "    echo '1 %s' | %s\n", request, r->adapter);
}

void conform_print(FILE *out, const conform_result *r)
{
    char name[CONFORM_TEXT], version[CONFORM_TEXT];

    fprintf(out, "%s %s, level %u, seed %llu: %zu requests, %zu of them refused rightly", conform_clean(name, r->hello.name),
            conform_clean(version, r->hello.version), r->options.level, (unsigned long long)r->options.seed, r->report.asked,
            r->report.refused_rightly);
    fprintf(out, r->report.skipped ? "; %zu skipped, because of timeouts or crashes in a row, or undecided\n" : "\n", r->report.skipped);
    if (r->stopped)
        fprintf(out, "Interrupted: this is what was known then.\n");
    put_table(out, r);
    for (size_t k = 0; k < r->report.findings; k++)
        put_finding(out, r, &r->report.finding[k], k + 1);
}
