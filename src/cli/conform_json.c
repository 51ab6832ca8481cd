/* conform_json: what `etalon conform` tells programs: JSON, JUnit's XML, baselines. */
#include "cli/conform.h"
#include "etalon/io/file.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- JSON ---- */

static json_t *clean_string(const char *text)
{
    char clean[CONFORM_TEXT];

    return text ? json_string(conform_clean(clean, text)) : json_null();
}

static json_t *real(double x)
{
    return isfinite(x) ? json_real(x) : json_null();
}

static json_t *hex(double x)
{
    char text[40];

    snprintf(text, sizeof text, "%a", x);
    return json_string(text);
}

/* Counts of all verdicts, of one operation or of all. */
static json_t *verdicts(const conform_result *r, int op)
{
    json_t *o = json_object();

    for (int v = 0; o && v < ET_VERDICTS; v++) {
        const size_t n = op < ET_OPS ? conform_of(r, (et_request_op)op, (et_verdict)v) : conform_total(r, (et_verdict)v);
        json_object_set_new(o, et_judge_name((et_verdict)v), json_integer((json_int_t)n));
    }
    return o;
}

static json_t *operations(const conform_result *r)
{
    json_t *all = json_object();

    for (int op = 0; all && op < ET_OPS; op++) {
        if (!r->options.op[op])
            continue;
        json_t *o = verdicts(r, op);
        json_object_set_new(o, "worst", real(r->report.worst[op]));
        json_object_set_new(all, et_request_name((et_request_op)op), o);
    }
    return all;
}

static json_t *categories(const conform_result *r)
{
    json_t *all = json_object();

    for (int c = 0; all && c < ET_CATEGORIES; c++) {
        json_t *o = json_object();
        for (int v = 0; o && v < ET_VERDICTS; v++) {
            size_t n = 0;
            for (int op = 0; op < ET_OPS; op++)
                n += r->report.count[op][c][v];
            json_object_set_new(o, et_judge_name((et_verdict)v), json_integer((json_int_t)n));
        }
        json_object_set_new(all, et_campaign_name((et_category)c), o);
    }
    return all;
}

static void set_judgement(json_t *o, const et_judgement *j)
{
    json_object_set_new(o, "text", clean_string(j->text));
    if (j->at == SIZE_MAX)
        return;
    json_object_set_new(o, "at", json_integer((json_int_t)j->at));
    json_object_set_new(o, "got", hex(j->got));
    json_object_set_new(o, "want", hex(j->want));
    json_object_set_new(o, "bound", hex(j->bound));
    json_object_set_new(o, "ratio", real(j->ratio));
}

static json_t *finding(const conform_result *r, const et_conform_finding *f)
{
    json_t *o = json_pack("{s:s, s:s, s:s, s:b}", "operation", et_request_name(f->op), "category", et_campaign_name(f->category), "verdict",
                          et_judge_name(f->judgement.verdict), "known", conform_known(r, f->op, f->category, f->judgement.verdict));
    if (!o)
        return NULL;
    set_judgement(o, f->shrunk ? &f->shrunk_judgement : &f->judgement);
    json_object_set_new(o, "request", cli_json_text(f->request));
    json_object_set_new(o, "reply", cli_json_text(f->reply));
    json_object_set_new(o, "shrunk", cli_json_text(f->shrunk));
    json_object_set_new(o, "shrunk_reply", cli_json_text(f->shrunk_reply));
    json_object_set_new(o, "vector", cli_json_text(f->vector));
    json_object_set_new(o, "issue", cli_json_text(f->issue));
    json_object_set_new(o, "relation", cli_json_text(f->relation));
    return o;
}

json_t *conform_bad_list(const conform_result *r)
{
    json_t *list = json_array();
    char key[CONFORM_KEY];

    for (int op = 0; op < ET_OPS; op++)
        for (int c = 0; c < ET_CATEGORIES; c++)
            for (int v = 0; list && v < ET_VERDICTS; v++)
                if (r->report.count[op][c][v] > 0 && et_judge_bad((et_verdict)v)) {
                    conform_key(key, (et_request_op)op, (et_category)c, (et_verdict)v);
                    json_array_append_new(list, json_string(key));
                }
    return list;
}

json_t *conform_json(const conform_result *r)
{
    json_t *findings = json_array(), *o = json_object();
    size_t requests;

    if (!o || !findings) {
        json_decref(o);
        json_decref(findings);
        return NULL;
    }
    for (size_t k = 0; k < r->report.findings; k++)
        json_array_append_new(findings, finding(r, &r->report.finding[k]));
    if (!r->greeted)
        json_array_append_new(findings, json_pack("{s:s, s:s, s:o}", "operation", "hello", "verdict", et_judge_name(r->greeting), "text",
                                                  clean_string(r->text.text)));
    json_object_set_new(o, "adapter", json_pack("{s:o, s:o, s:o}", "name", clean_string(r->hello.name), "version", clean_string(r->hello.version),
                                                "command", clean_string(r->adapter)));
    json_object_set_new(o, "level", json_integer((json_int_t)r->options.level));
    json_object_set_new(o, "seed", r->options.seed <= INT64_MAX ? json_integer((json_int_t)r->options.seed)
                                                                : json_sprintf("%llu", (unsigned long long)r->options.seed));
    json_object_set_new(o, "verdicts", verdicts(r, ET_OPS));
    json_object_set_new(o, "operations", operations(r));
    json_object_set_new(o, "categories", categories(r));
    json_object_set_new(o, "asked", json_integer((json_int_t)r->report.asked));
    json_object_set_new(o, "refused_rightly", json_integer((json_int_t)r->report.refused_rightly));
    json_object_set_new(o, "skipped", json_integer((json_int_t)r->report.skipped));
    json_object_set_new(o, "known", conform_bad_list(r));
    json_object_set_new(o, "new", json_integer((json_int_t)conform_new(r, &requests)));
    json_object_set_new(o, "interrupted", json_boolean(r->stopped));
    json_object_set_new(o, "findings", findings);
    return o;
}

/* ---- baselines ---- */

et_status conform_read_baseline(json_t **known, const char *path, et_message *message)
{
    json_t *all;
    const et_status status = cli_json_load(&all, path, message);

    if (status != ET_OK)
        return status;
    json_t *list = json_object_get(all, "known");
    int right = json_is_array(list);
    for (size_t k = 0; right && k < json_array_size(list); k++)
        right = json_is_string(json_array_get(list, k));
    if (right)
        *known = json_incref(list);
    json_decref(all);
    return right ? ET_OK : et_status_fail(message, ET_EFORMAT, "%s: no list `known` of strings: not a baseline", path);
}

/* ---- JUnit ---- */

static void put_escaped(FILE *out, const char *text)
{
    char clean[CONFORM_TEXT];

    for (const char *c = conform_clean(clean, text); *c; c++) {
        const char *name = *c == '&' ? "&amp;" : *c == '<' ? "&lt;" : *c == '>' ? "&gt;" : *c == '"' ? "&quot;" : *c == '\'' ? "&apos;" : NULL;
        if (name)
            fputs(name, out);
        else
            fputc(*c, out);
    }
}

typedef struct { size_t tests, failed, skipped, bad, fresh, asked; } suite;

/* Of one operation and category: what was asked, bad, new, unsupported. */
static suite look(const conform_result *r, et_request_op op, et_category category)
{
    suite s = { 0, 0, 0, 0, 0, 0 };

    for (int v = 0; v < ET_VERDICTS; v++) {
        const size_t n = r->report.count[op][category][v];
        s.asked += n;
        if (v == ET_VERDICT_UNSUPPORTED)
            s.skipped += n;
        if (!et_judge_bad((et_verdict)v))
            continue;
        s.bad += n;
        s.fresh += conform_known(r, op, category, (et_verdict)v) ? 0 : n;
    }
    s.tests = s.asked > 0;
    return s;
}

static void put_failure(FILE *out, const conform_result *r, et_request_op op, et_category category, const suite *s)
{
    fprintf(out, "    <failure message=\"%zu of %zu\">", s->fresh, s->asked);
    for (int v = 0; v < ET_VERDICTS; v++)
        if (r->report.count[op][category][v] > 0 && et_judge_bad((et_verdict)v))
            fprintf(out, "%s: %zu\n", et_judge_name((et_verdict)v), r->report.count[op][category][v]);
    for (size_t k = 0; k < r->report.findings; k++) {
        const et_conform_finding *f = &r->report.finding[k];
        if (f->op != op || f->category != category)
            continue;
        put_escaped(out, f->shrunk ? f->shrunk_judgement.text : f->judgement.text);
        fputs("\necho '1 ", out);
        fputs(f->shrunk ? f->shrunk : f->request, out);
        fputs(conform_compound(r->adapter) ? "' | (" : "' | ", out);
        put_escaped(out, r->adapter);
        fputs(conform_compound(r->adapter) ? ")\n" : "\n", out);
    }
    fputs("</failure>\n", out);
}

static void put_testcase(FILE *out, const conform_result *r, et_request_op op, et_category category)
{
    const suite s = look(r, op, category);

    if (s.tests == 0)
        return;
    fprintf(out, "  <testcase classname=\"%s\" name=\"%s\">\n", et_request_name(op), et_campaign_name(category));
    if (s.fresh > 0)
        put_failure(out, r, op, category, &s);
    else if (s.bad > 0)
        fprintf(out, "    <skipped message=\"%zu of %zu, all of them known\"/>\n", s.bad, s.asked);
    else if (s.skipped == s.asked)
        fputs("    <skipped message=\"unsupported\"/>\n", out);
    fputs("  </testcase>\n", out);
}

static void put_junit(FILE *out, const conform_result *r)
{
    suite all = { 0, 0, 0, 0, 0, 0 };

    for (int op = 0; op < ET_OPS; op++)
        for (int c = 0; c < ET_CATEGORIES; c++) {
            const suite s = look(r, (et_request_op)op, (et_category)c);
            all.tests += s.tests;
            all.failed += s.fresh > 0;
            all.skipped += s.tests && s.fresh == 0 && (s.bad > 0 || s.skipped == s.asked);
        }
    fputs("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n<testsuite name=\"", out);
    put_escaped(out, r->greeted ? r->hello.name : r->adapter);
    fprintf(out, "\" tests=\"%zu\" failures=\"%zu\" errors=\"0\" skipped=\"%zu\">\n", all.tests + !r->greeted, all.failed + !r->greeted, all.skipped);
    if (!r->greeted) {
        fprintf(out, "  <testcase classname=\"hello\" name=\"%s\">\n    <failure message=\"", et_judge_name(r->greeting));
        put_escaped(out, r->text.text);
        fputs("\"/>\n  </testcase>\n", out);
    }
    for (int op = 0; op < ET_OPS; op++)
        for (int c = 0; c < ET_CATEGORIES; c++)
            put_testcase(out, r, (et_request_op)op, (et_category)c);
    fputs("</testsuite>\n</testsuites>\n", out);
}

et_status conform_write_junit(const char *path, const conform_result *r, et_message *message)
{
    et_file file;
    const et_status status = et_file_create(&file, path, message);

    if (status != ET_OK)
        return status;
    put_junit(file.stream, r);
    return et_file_commit(&file, message);
}
