/* conform/judge: answers at the limits of what is judged, each with the verdict and the words that are right. */
#include "conform/judge_kit.h"
#include "etalon/exact/exact.h"
#include <stdint.h>
#include <stdio.h>

verdict prop_judge_truth_beyond(gen *g);
verdict prop_judge_truth_no_normal(gen *g);
verdict prop_judge_validity_words(gen *g);
verdict prop_judge_reply_cases(gen *g);
verdict prop_judge_reply_four_limits(gen *g);
verdict prop_judge_reply_foreign(gen *g);
verdict prop_judge_reply_factor(gen *g);
verdict prop_judge_reply_doubt(gen *g);
verdict prop_judge_reply_high_order(gen *g);

static et_truth truth_of(gen *g, const et_request *q, const char *line)
{
    et_truth t = { 0 };

    gen_check(g, et_judge_truth(&t, q) == ET_OK, "%s: no truth", line);
    return t;
}

/* The numbers of a line. */
static et_reply numbers(const char *text)
{
    et_reply reply = { ET_REPLY_OK, 0, NULL, "" };
    char *end;

    for (double x = strtod(text, &end); end != text; x = strtod(text, &end)) {
        if (et_reply_put(&reply, &x, 1) != ET_OK)
            abort();
        text = end;
    }
    return reply;
}

/* An invalid request whose truth gives no reason. */
verdict prop_judge_reply_no_reason(gen *g);

/* One case in 1000. */
verdict prop_judge_reply_no_reason(gen *g)
{
    const et_truth t = { ET_INVALID, "", 0, NULL, NULL, NULL, NULL, 1 };
    et_request q = kit_parse("net_counts 1 1");
    const double x[3] = { 2, 1, 0 };
    const et_judgement j = kit_judge(g, &q, &t, x, 3);
    const bool ok = kit_is(g, &j, ET_VERDICT_WRONGLY_ACCEPTED, "net_counts 1 1")
                    && gen_check(g, strcmp(j.text, "answered, though the request is invalid") == 0, "%s", j.text);

    et_request_free(&q);
    return ok ? PASS : FAIL;
}

/* ---- what is right ---- */

/* Numbers of an answer, or what their bounds are made of, beyond the range of doubles: nobody has to answer, and those numbers may be any. */
static const struct { const char *line, *reason; size_t at; double want; } beyond[] = {
    { "curve_insert 1 4 0 0 1 1 2 0x1p+600 0 0 0x1p+601 0 0 2 0x1p+600 0x1p+600 0x1p-1 1", "a number of the answer, or what it is made of", 11,
      0x1.8p+600 },
    { "curve_ders 1 4 0 0 1 1 2 -0x1.8p+1023 0 0 0x1.8p+1023 0 0 0 0x1p-1 any 1", "a number of the answer, or what it is made of", 3,
        (double)INFINITY },
    { "curve_ders 1 4 0 0x1p-1 1 0x1.8p+0 2 -0x1.8p+1023 0 0 0x1.8p+1023 0 0 0 0x1.8p-1 any 1", "the knots are not clamped", 3, (double)INFINITY },
    { "curve_remove 2 7 0 0 0 0x1p-1 1 1 1 4 0 0 0 0x1p+1023 0 0 0x1p+1023 0 0 0 0 0 0 0x1p-1 1 0",
        "a number of the answer, or what it is made of", 13,
      (double)INFINITY },
    { "surface_normal 1 1 4 0 0 0x1p+10 0x1p+10 4 0 0 1 1 4 0 0 0 0 1 0 0x1p-1074 0 0 0x1p-1074 1 0 0 0x1p-1 0x1p-1",
      "a number of the answer, or what it is made of", 2, 1 },
    { "surface_normal 1 1 4 0 0 1 1 4 0 0 1 1 4 -0x1.8p+1023 0 0 -0x1.8p+1023 1 0 0x1.8p+1023 0 0 0x1.8p+1023 1 0 0 0x1p-1 0x1p-1",
      "a number of the answer, or what it is made of", 2, 1 },
    { "curve_nearest 1 4 0 0 1 1 2 -0x1.8p+1023 0 0 0x1.8p+1023 0 0 0 1 0 1 0", "a number of the answer, or what it is made of", 1, 1 },
};

/* One case in 1000. */
verdict prop_judge_truth_beyond(gen *g)
{
    bool ok = true;

    for (size_t k = 0; ok && k < sizeof beyond / sizeof *beyond; k++) {
        et_request q = kit_parse(beyond[k].line);
        et_truth t = truth_of(g, &q, beyond[k].line);
        const size_t at = beyond[k].at;
        ok = gen_check(g, t.validity == ET_IMPLEMENTATION_DEFINED && strncmp(t.reason, beyond[k].reason, strlen(beyond[k].reason)) == 0, "%s: %s",
                       beyond[k].line, t.reason);
        ok = ok && gen_check(g, at < t.count && t.want[at] == beyond[k].want && isinf(t.bound[at]), "%s: number %zu is %a, bound %a",
            beyond[k].line, at,
                             t.want[at], t.bound[at]);
        if (ok) {
            const double free_one = t.want[at];
            t.want[at] = -7;
            et_reply reply = kit_reply(t.want, t.count);
            t.want[at] = free_one;
            et_judgement j;
            ok = gen_check(g, et_judge_reply(&j, &q, &t, &reply) == ET_OK, "judged");
            /* a removal need not be the exact one, but near; the distance is that at the parameter answered: another one's is false */
            ok = ok && (q.op == ET_OP_CURVE_NEAREST || q.op == ET_OP_CURVE_REMOVE || gen_check(g,
                j.verdict == ET_VERDICT_WITHIN_BOUND && j.text[0] == '\0', "%s: %s %s",
                                                                 beyond[k].line, et_judge_name(j.verdict), j.text));
            et_reply_free(&reply);
        }
        et_judge_free(&t);
        et_request_free(&q);
    }
    return ok ? PASS : FAIL;
}

/* Bilinear patches that do not meet, the surfaces' knots 1/2 twice: the limits there are those of different patches. */
#define JUMP "6 0 0 0x1p-1 0x1p-1 1 1 "
#define PLAIN "4 0 0 1 1 "
#define NONE "5 5 5 5 5 5 "
#define FLAT_0 "0 0 0 0 1 0 1 0 0 1 1 0 "
static const struct { const char *line; size_t count; } half_normals[] = {
    { "surface_normal 1 1 " JUMP PLAIN "8 " FLAT_0 NONE NONE "0 0x1p-1 0x1p-2", 0 },
    { "surface_normal 1 1 " JUMP PLAIN "8 " NONE NONE FLAT_0 "0 0x1p-1 0x1p-2", 0 },
    { "surface_normal 1 1 " JUMP PLAIN "8 " NONE NONE NONE NONE "0 0x1p-1 0x1p-2", 0 },
    { "surface_normal 1 1 " JUMP PLAIN "8 " NONE NONE FLAT_0 "0 0x1.8p-1 0x1p-2", 3 },
};

/* A normal that one limit has and the other has not: there is no right value, from whichever side it is missing. */
/* One case in 1000. */
verdict prop_judge_truth_no_normal(gen *g)
{
    static const double any[3] = { 7, (double)NAN, 0 };
    bool ok = true;

    for (size_t k = 0; ok && k < sizeof half_normals / sizeof *half_normals; k++) {
        et_request q = kit_parse(half_normals[k].line);
        et_truth t = truth_of(g, &q, half_normals[k].line);
        const bool none = half_normals[k].count == 0;
        ok = gen_check(g,
            t.count == half_normals[k].count && !t.other && t.condition >= 1 && t.validity == (none ? ET_IMPLEMENTATION_DEFINED : ET_VALID),
                       "case %zu: %zu numbers, %s", k, t.count, t.reason)
             && gen_check(g, strcmp(t.reason, none ? "there is no normal" : "") == 0, "case %zu: %s", k, t.reason);
        const et_judgement j = kit_judge(g, &q, &t, any, 3);
        ok = ok && kit_is(g, &j, none ? ET_VERDICT_WITHIN_BOUND : ET_VERDICT_NON_FINITE, "any answer");
        et_judge_free(&t);
        et_request_free(&q);
    }
    return ok ? PASS : FAIL;
}

#define SQUARE "4 0 0 0 0 1 0 1 0 0 1 1 0 "
static const struct { const char *line; size_t arg, count; et_validity is; const char *reason; } worded[] = {
    { "fit_grid free 1 1 " PLAIN PLAIN "2 0 2 2 0 1 " SQUARE, 0, 0, ET_INVALID, "a parameter is outside the domain" },
    { "fit_grid free 1 1 " PLAIN PLAIN "2 0 1 2 0 2 " SQUARE, 0, 0, ET_INVALID, "a parameter is outside the domain" },
    { "approximate 1 1 2 2 9007199254740992 9007199254740992 0", 0, 1, ET_INVALID, "parameters and data differ in number" },
    { "knots uniform 1 2 2 0 1", 2, SIZE_MAX, ET_IMPLEMENTATION_DEFINED, "an answer of more than 10^6 numbers" },
    { "seam_gap 1 1 " PLAIN PLAIN SQUARE "0 1 1 4 0 0 1 2 " PLAIN SQUARE "0 1", 0, 1, ET_IMPLEMENTATION_DEFINED, "the knots are not clamped" },
    { "seam_gap 1 1 " PLAIN PLAIN SQUARE "0 1 1 " PLAIN "4 -1 0 1 1 " SQUARE "0 1", 0, 1, ET_IMPLEMENTATION_DEFINED, "the knots are not clamped" },
};

/* The reason is the one that holds; `arg` gets a count that no line may hold. */
/* One case in 1000. */
verdict prop_judge_validity_words(gen *g)
{
    bool ok = true;

    for (size_t k = 0; ok && k < sizeof worded / sizeof *worded; k++) {
        et_request q = kit_parse(worded[k].line);
        char reason[128];
        q.arg[worded[k].arg].count = worded[k].count;
        const et_validity v = et_judge_validity(reason, &q);
        ok = gen_check(g, v == worded[k].is && strcmp(reason, worded[k].reason) == 0, "%s: %s, %s", worded[k].line,
            et_judge_validity_name(v), reason);
        et_truth t = truth_of(g, &q, worded[k].line);
        ok = ok && gen_check(g, t.validity == v && t.count == 0 && strcmp(t.reason, reason) == 0, "%s: %zu numbers, %s", worded[k].line,
            t.count, t.reason);
        et_judge_free(&t);
        et_request_free(&q);
    }
    return ok ? PASS : FAIL;
}

/* ---- verdicts ---- */

#define PARABOLA "2 6 0 0 0 1 1 1 3 0 0 0 1 2 0 4 0 1 "
#define KINK "2 7 0 0 0 0x1p-1 1 1 1 4 0 0 0 1 2 0 2 2 0 3 0 1 "
#define STEPS "surface_nearest 1 1 " PLAIN JUMP "8 0 0 0 0 1 0 0 2 1 0 3 1 1 0 0 1 1 0 1 2 1 1 3 1 0 1 0x1p-1 1 -1"
#define STEPS_IN_U "surface_nearest 1 1 " JUMP PLAIN "8 0 0 0 1 0 0 0 1 0 1 1 0 0 2 1 1 2 1 0 3 1 1 3 1 0 1 0x1p-1 1 -1"
#define THREE "1 7 0 0 0x1p-1 0x1p-1 0x1p-1 1 1 5 0 0 0 1 0 0 9 9 9 2 0 0 3 0 0 0 0x1p-1 1 "
#define CASE(request, answer, is, words) { request, answer, ET_VERDICT_##is, words }
static const struct { const char *line, *answer; et_verdict is; const char *says; } cases[] = {
    /* a number further from the right one than any double */
    CASE("curve_point 1 4 0 0 1 1 2 0x1.8p+1021 0 0 0x1.8p+1021 0 0 0 0x1p-1 any", "-0x1.fp+1023 0 0", WRONG, "x of the point is -0x1.fp+1023"),
    /* weights where none are wanted */
    CASE("curve_insert 1 4 0 0 1 1 2 0 0 0 2 0 0 0 0x1p-1 1", "1 5 0 0 0.5 1 1 3 0 0 0 1 0 0 2 0 0 3 7 7 7", CORRECTLY_ROUNDED, ""),
    CASE("curve_insert 1 4 0 0 1 1 2 0 0 0 2 0 0 0 0x1p-1 1", "1 5 0 0 0.5 1 1 3 0 0 0 1 0 0 2 0 0 3 7 8 7", WRONG, "weights of a polynomial"),
    CASE("curve_insert 1 4 0 0 1 1 2 0 0 0 2 0 0 0 0x1p-1 1", "1 5 0 0 0.5 1 1 3 0 0 0 1 0 0 2 0 0 3 inf inf inf", WRONG, "weights of a polynomial"),
    CASE("curve_insert 1 4 0 0 1 1 2 0 0 0 2 0 0 0 0x1p-1 1", "1 5 0 0 0.5 1 1 3 0 0 0 1 0 0 2 0 0 3 0 0 0", WRONG, "weights of a polynomial"),
    CASE("curve_insert 1 4 0 0 1 1 2 0 0 0 2 0 0 0 0x1p-1 1", "1 5 0 0 0.5 1 1 3 0 0 0 1 0 0 2 0 0 3 1 -1 1", WRONG, "weights of a polynomial"),
    /* a knot said to be gone more often than it stood there */
    CASE("curve_remove " KINK "0 0x1p-1 3 0x1p+10", "2 2 5 0 0 1 1 1 2 0 0 0 3 0 1 0", WRONG, "16 numbers that"),
    CASE("curve_remove " KINK "0 0x1p-1 3 0x1p+10", "2 1 4 0 0 1 1 2 0 0 0 3 0 1 0", WRONG, "t is 2, should be 1"),
    CASE("curve_remove " KINK "0 0x1p-1 0 0x1p+10", "1 1 4 0 0 1 1 2 0 0 0 3 0 1 0", WRONG, "t is 1, should be 0"),
    /* a knot that stood so often that it cannot be put back: points are compared */
    CASE("curve_remove " THREE "0x1p-6", "1 1 6 0 0 0.5 0.5 1 1 4 0 0 0 1 0 0 2 0 0 3 0 0 0", CORRECTLY_ROUNDED, ""),
    CASE("curve_remove " THREE "0x1p-6", "1 1 6 0 0 0.5 0.5 1 1 4 0 0 0 1 0x1p-7 0 2 0 0 3 0 0 0", WITHIN_BOUND, ""),
    CASE("curve_remove " THREE "0x1p-6", "1 1 6 0 0 0.5 0.5 1 1 4 0 0 0 1 0x1p-5 0 2 0 0 3 0 0 0", WRONG, "after removal a point is 0.03125 away"),
    /* where a surface jumps the side counts from which it is nearer */
    CASE(STEPS, "0.5 0.5 1", CORRECTLY_ROUNDED, ""), CASE(STEPS_IN_U, "0.5 0.5 1", CORRECTLY_ROUNDED, ""),
    CASE(STEPS, "0.5 0.5 0x1.1e3779b97f4a8p+1", WRONG, "the distance is said to be"),
    CASE(STEPS, "0.5 0.25 0x1.1e3779b97f4a8p+0", WRONG, "a point 0x1.1e3779b97f4a8p+0"),
    CASE(STEPS, "0.5 1.5 1", WRONG, "the parameter 0x1.8p+0"), CASE(STEPS, "nan 0.5 1", NON_FINITE, "the parameter is"),
    /* what nobody need approximate may be answered in any way */
    CASE("approximate 0 1 2 2 2 2 " SQUARE, "1 2 3", WITHIN_BOUND, ""),
    CASE("approximate 1 1 2 2 2 2 " SQUARE, "1 1 4 0 0 1 1 4 0 0 1 1 4 0 0 0 0 1 0 1 0 0 1 1 0 0", WITHIN_BOUND, ""),
    CASE("approximate 1 1 2 2 2 2 " SQUARE, "1 1 4 -1 0 1 2 4 -1 0 1 2 4 0 0 0 0 1 0 1 0 0 1 1 0 4 1 2 3 4", WITHIN_BOUND, ""),
    CASE("approximate 1 1 2 2 2 2 " SQUARE, "1 1 4 0 0 2 2 4 0 0 1 1 4 0 0 0 0 1 0 1 0 0 1 1 0 0", WRONG, "the knots are not those"),
    CASE("approximate 1 1 2 2 2 2 " SQUARE, "1 1 4 0 0 1 1 4 0 0 2 2 4 0 0 0 0 1 0 1 0 0 1 1 0 0", WRONG, "the knots are not those"),
    CASE("approximate 1 1 2 2 2 2 " SQUARE, "1 1 4 -1 -1 1 1 4 0 0 1 1 4 0 0 0 0 1 0 1 0 0 1 1 0 0", WRONG, "the knots are not those"),
    CASE("approximate 1 1 2 2 2 2 " SQUARE, "1 1 4 0 0 1 1 4 -1 -1 1 1 4 0 0 0 0 1 0 1 0 0 1 1 0 0", WRONG, "the knots are not those"),
    CASE("approximate 1 1 2 2 2 2 " SQUARE, "1 1 4 0 0 1 1 4 1 0 1 1 4 0 0 0 0 1 0 1 0 0 1 1 0 0", WRONG, "the knots are not those"),
    CASE("approximate 1 1 2 2 2 2 " SQUARE, "1 1 4 0 0 1 1 4 0 0 1 1 4 0 0 0 0 1 0 1 0 0 1 1 0 4 1 0 1 1", WRONG, "weight 1 is 0"),
    CASE("approximate 1 1 2 2 2 2 " SQUARE, "1 1 4 0 0 1 1 4 0 0 1 1 4 0 0 0 0 1 0 1 0 0 1 1 0 4 1 1 1 inf", NON_FINITE, "weight 3 is inf"),
    CASE("approximate 1 1 2 2 2 2 " SQUARE, "1 1 4 0 0 1 1 5 0 0 0.5 1 1 6 0 0 0 0 1 0 0 2 0 1 0 0 1 1 0 1 2 0 0", WRONG,
         "the number of control points in v is 3, should be 2"),
    /* derivatives are counted in English */
    CASE("curve_ders 1 4 0 0 1 1 2 0 0 0 1 0 0 0 0 any 12", "0 0 0 1 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 1 0 0", WRONG,
         "x of the 12th derivative is 0x1p+0"),
    CASE("curve_ders 1 4 0 0 1 1 2 0 0 0 1 0 0 0 0 any 13",
        "0 0 0 1 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 1 0", WRONG,
         "y of the 13th derivative is 0x1p+0"),
};

/* One case in 1000. */
verdict prop_judge_reply_cases(gen *g)
{
    bool ok = true;

    for (size_t k = 0; ok && k < sizeof cases / sizeof *cases; k++) {
        et_request q = kit_parse(cases[k].line);
        et_truth t = truth_of(g, &q, cases[k].line);
        et_reply reply = numbers(cases[k].answer);
        et_judgement j = { ET_VERDICTS, 0, 0, 0, 0, 0, "" };
        ok = gen_check(g, et_judge_reply(&j, &q, &t, &reply) == ET_OK, "judged") && kit_is(g, &j, cases[k].is, cases[k].line);
        ok = ok && gen_check(g, strncmp(j.text, cases[k].says, strlen(cases[k].says)) == 0 && (j.text[0] != '\0') == (cases[k].says[0] != '\0'),
                             "%s: %s: '%s', not '%s'", cases[k].line, cases[k].answer, j.text, cases[k].says);
        ok = ok && gen_check(g, j.verdict != ET_VERDICT_WRONG || j.ratio > 0x1p20, "%s: ratio %a", cases[k].line, j.ratio);
        ok = ok && gen_check(g, k > 0 || (isfinite(j.ratio) && j.ratio > 0x1p40), "a great ratio, %a", j.ratio);
        et_reply_free(&reply);
        et_judge_free(&t);
        et_request_free(&q);
    }
    return ok ? PASS : FAIL;
}

/* Where both directions jump, the limit from the right in one and from the left in the other counts, too: of the four patches' normals each is right,
 * and where one patch has none any answer will do. */
/* One case in 1000. */
verdict prop_judge_reply_four_limits(gen *g)
{
    /* low u, low v: normal x; low u, high v: normal y; high u, low v: none, or -z; high u, high v: z */
    static const char *const lines[2] = {
        "surface_normal 1 1 " JUMP JUMP "16 0 0 0 0 0 1 0 0 0 1 0 0 0 1 0 0 1 1 0 0 1 1 0 1 "
            "0 0 0 1 0 0 0 0 0 0 1 0 0 1 0 1 1 0 1 0 0 1 1 0 0 0x1p-1 0x1p-1",
        "surface_normal 1 1 " JUMP JUMP "16 0 0 0 0 0 1 0 0 0 1 0 0 0 1 0 0 1 1 0 0 1 1 0 1 "
            "5 5 5 5 5 5 0 0 0 0 1 0 5 5 5 5 5 5 1 0 0 1 1 0 0 0x1p-1 0x1p-1" };
    static const struct { double n[3]; et_verdict is[2]; } answers[] = {
        { { 0, 0, 1 }, { ET_VERDICT_CORRECTLY_ROUNDED, ET_VERDICT_CORRECTLY_ROUNDED } },
        { { 1, 0, 0 }, { ET_VERDICT_CORRECTLY_ROUNDED, ET_VERDICT_CORRECTLY_ROUNDED } },
        { { 0, 1, 0 }, { ET_VERDICT_CORRECTLY_ROUNDED, ET_VERDICT_CORRECTLY_ROUNDED } },
        { { 0, 0, -1 }, { ET_VERDICT_CORRECTLY_ROUNDED, ET_VERDICT_WITHIN_BOUND } },
        { { 0.6, 0.8, 0 }, { ET_VERDICT_WRONG, ET_VERDICT_WITHIN_BOUND } },
        { { (double)NAN, 0, 0 }, { ET_VERDICT_NON_FINITE, ET_VERDICT_WITHIN_BOUND } },
    };
    bool ok = true;

    for (size_t k = 0; ok && k < 2; k++) {
        et_request q = kit_parse(lines[k]);
        et_truth t = truth_of(g, &q, lines[k]);
        ok = gen_check(g, t.validity == ET_VALID && t.count == 3 && t.other, "two limits");
        for (size_t i = 0; ok && i < sizeof answers / sizeof *answers; i++) {
            const et_judgement j = kit_judge(g, &q, &t, answers[i].n, 3);
            gen_note(g, "line %zu, answer %zu", k, i);
            ok = kit_is(g, &j, answers[i].is[k], "a normal");
        }
        et_judge_free(&t);
        et_request_free(&q);
    }
    return ok ? PASS : FAIL;
}

/* A truth read from anywhere may not be this request's: then nothing is judged. */
static const struct { const char *line, *want, *answer; } foreign[] = {
    { "curve_insert " PARABOLA "0 0x1p-1 1", "1 2 3", "1 2 3" },
    { "curve_insert " PARABOLA "0 0x1p-1 1", "1 4 0 0 1 1 2 0 0 0 1 0 0 0 9", "1 4 0 0 1 1 2 0 0 0 1 0 0 0" },
    { "curve_insert 1 4 0 0 1 1 3 0 0 0 1 0 0 2 0 0 0 0x1p-1 1", "1 5 0 0 0.5 1 1 3 0 0 0 1 0 0 2 0 0 0", "1 5 0 0 0.5 1 1 3 0 0 0 1 0 0 2 0 0 0" },
    { "curve_remove 1 4 0 0 1 1 3 0 0 0 1 0 0 2 0 0 0 0x1p-1 1 0", "0", "0 1 4 0 0 1 1 2 0 0 0 1 0 0 0" },
    { "basis 1 2 0 1 0 any", "1", "2" }, { "basis_ders 1 2 0 1 0 any 0", "1 2", "2 1" },
    { "curve_nearest " PARABOLA "0 1 0 0 0", "1", "1" }, { "curve_nearest " PARABOLA "0 0", "0 1", "0 1" }, { STEPS, "1", "1" },
    { STEPS, "0 1", "0 1" }, { STEPS, "0 0 1 1", "0 0 1 1" },
};

/* One case in 1000. */
verdict prop_judge_reply_foreign(gen *g)
{
    bool ok = true;

    for (size_t k = 0; ok && k < sizeof foreign / sizeof *foreign; k++) {
        et_request q = kit_parse(foreign[k].line);
        et_reply want = numbers(foreign[k].want), bound = numbers(foreign[k].want), answer = numbers(foreign[k].answer);
        const et_truth t = { ET_VALID, "", want.count, want.x, bound.x, NULL, NULL, 1 };
        et_judgement j, before;
        memset(&j, 0x5a, sizeof j);
        memcpy(&before, &j, sizeof j);
        const et_status status = et_judge_reply(&j, &q, &t, &answer);
        ok = gen_check(g, status == ET_EINVAL && memcmp(&j, &before, sizeof j) == 0, "%s, wanted %s: status %d", foreign[k].line, foreign[k].want,
                       (int)status);
        et_reply_free(&want);
        et_reply_free(&bound);
        et_reply_free(&answer);
        et_request_free(&q);
    }
    return ok ? PASS : FAIL;
}

/* Weights may have any factor in common, however great or small it is, even one that is no double. */
/* One case in 1000. */
verdict prop_judge_reply_factor(gen *g)
{
    static const int exponents[] = { 0, 1, -1, 600, -600, 1000, -1000 };
    bool ok = true;

    for (size_t a = 0; ok && a < 7; a++)
        for (size_t b = 0; ok && b < 7; b++) {
            char line[200];
            snprintf(line, sizeof line, "curve_insert 1 4 0 0 1 1 2 0 0 0 2 0 0 2 %a %a 0x1p-1 1", ldexp(1, exponents[a]), ldexp(3, exponents[a]));
            et_request q = kit_parse(line);
            et_truth t = truth_of(g, &q, line);
            double x[22];
            ok = gen_check(g, t.count == 21 && t.want[20] == ldexp(3, exponents[a]), "%s: %zu numbers", line, t.count);
            for (size_t i = 0; ok && i < 21; i++)
                x[i] = i < 18 ? t.want[i] : ldexp((double)(i - 17), exponents[b]);
            et_judgement j = kit_judge(g, &q, &t, x, 21);
            ok = ok && kit_is(g, &j, ET_VERDICT_CORRECTLY_ROUNDED, "a factor");
            x[19] = ldexp(2.5, exponents[b]);
            j = kit_judge(g, &q, &t, x, 21);
            ok = ok && kit_is(g, &j, ET_VERDICT_WRONG, "another weight") && gen_check(g, strncmp(j.text, "weight 1 is 0x", 14) == 0, "%s", j.text);
            x[20] = INFINITY;
            j = kit_judge(g, &q, &t, x, 21);
            ok = ok && kit_is(g, &j, ET_VERDICT_NON_FINITE, "a weight that is no number");
            et_judge_free(&t);
            et_request_free(&q);
        }
    return ok ? PASS : FAIL;
}

/* After removal all control points within the tolerance: right.  Some beyond it but no point of the curve: not proved wrong, so not called wrong. */
/* One case in 1000. */
verdict prop_judge_reply_doubt(gen *g)
{
    static const struct { double share; et_verdict is; double ratio; } all[] = {
        { 0.8, ET_VERDICT_WITHIN_BOUND, 0.75 / 0.8 }, { 0.6, ET_VERDICT_WITHIN_BOUND, 1 }, { 0.45, ET_VERDICT_WITHIN_BOUND, 1 },
        { 0.4, ET_VERDICT_WRONG, 0 } };
    const double off = 0x1p-10, x = 0.25;
    double u[] = { 0, 0, 0, 0, 1, 1, 1, 1 };
    et_vec3 P[4] = { { 0, 0, 0 }, { 1, 2, 0 }, { 2, -1, 0 }, { 4, 0, 0 } };
    et_curve c = { 3, 4, u, P, NULL }, more;
    et_request q;

    if (et_exact_curve_insert(&more, &c, x, 1) != ET_OK || et_request_new(&q, ET_OP_CURVE_REMOVE) != ET_OK)
        return FAIL;
    bool ok = et_request_set(&q, 0, 3, NULL) == ET_OK && et_request_set(&q, 1, 9, more.u) == ET_OK && et_request_set(&q, 2, 5,
        &more.points->x) == ET_OK
              && et_request_set(&q, 4, 0, &x) == ET_OK && et_request_set(&q, 5, 1, NULL) == ET_OK;
    /* Of the control points after insertion one goes by 3/4 of it, of the curve a point by 4/9. */
    P[1].y += off;
    for (size_t k = 0; ok && k < sizeof all / sizeof *all; k++) {
        const double tolerance = all[k].share * off, one = 1;
        et_reply reply = { ET_REPLY_OK, 0, NULL, "" };
        et_judgement j;
        ok = et_request_set(&q, 6, 0, &tolerance) == ET_OK;
        et_truth t = truth_of(g, &q, "curve_remove");
        ok = ok && et_reply_put(&reply, &one, 1) == ET_OK && et_reply_put_curve(&reply, &c) == ET_OK
             && gen_check(g, et_judge_reply(&j, &q, &t, &reply) == ET_OK, "judged") && kit_is(g, &j, all[k].is, "a point moved");
        ok = ok && gen_check(g, all[k].is == ET_VERDICT_WRONG ? strncmp(j.text, "after removal a point is 0.000", 30) == 0 && j.ratio > 0x1p20
                                                                  && j.got > 0.4 * off && j.got < 0.4445 * off
                                                              : j.text[0] == '\0' && fabs(j.ratio - all[k].ratio) < 1e-9,
                             "tolerance %g: %a, ratio %g, '%s'", all[k].share, j.got, j.ratio, j.text);
        et_reply_free(&reply);
        et_judge_free(&t);
    }
    et_curve_free(&more);
    et_request_free(&q);
    return ok ? PASS : FAIL;
}

/* Derivatives of so high an order that nobody need know them, from a truth that does: named by numbers instead of letters. */
/* One case in 1000. */
verdict prop_judge_reply_high_order(gen *g)
{
    enum { ORDER = 16, N = 3 * (ORDER + 1) * (ORDER + 2) / 2 };
    static const char line[] = "surface_ders 1 1 " PLAIN PLAIN "4 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 any any 16";
    static const struct { size_t order, b; const char *says; } named[] = {
        { 15, 4, "y of S_uuuuuuuuuuuvvvv is 1, should be 0" }, { 16, 5, "y of the derivative 11 times in u, 5 in v is 1, should be 0" },
        { 16, 16, "y of the derivative 0 times in u, 16 in v is 1, should be 0" } };
    double want[N] = { 0 }, bound[N] = { 0 }, x[N];
    const et_truth t = { ET_IMPLEMENTATION_DEFINED, "derivatives of too high an order", N, want, bound, NULL, NULL, 1 };
    et_request q = kit_parse(line);
    bool ok = true;

    for (size_t k = 0; ok && k < 3; k++) {
        memset(x, 0, sizeof x);
        x[3 * (named[k].order * (named[k].order + 1) / 2 + named[k].b) + 1] = 1;
        const et_judgement j = kit_judge(g, &q, &t, x, N);
        ok = kit_is(g, &j, ET_VERDICT_WRONG, line) && gen_check(g, strcmp(j.text, named[k].says) == 0, "%s, not %s", j.text, named[k].says);
    }
    et_request_free(&q);
    return ok ? PASS : FAIL;
}
