/* conform/judge: verdicts of right replies, of replies a little and far too far off, and of planted faults. */
#include "etalon/exact/exact.h"
#include "judge_kit.h"
#include <stdint.h>

/* A request and its truth; 1 if there is one with numbers (or none at all is asked for). */
static int drawn(gen *g, et_request *r, et_truth *t, et_request_op op, bool numbers)
{
    if (!kit_draw(g, r, op, ET_CATEGORIES))
        return -1;
    const et_status status = et_judge_truth(t, r);
    if (status == ET_OK && (!numbers || t->count > 0))
        return 1;
    if (status == ET_OK)
        et_judge_free(t);
    et_request_free(r);
    return gen_check(g, status == ET_OK || status == ET_ENOCONV, "%s", et_status_text(status)) ? 0 : -1;
}

static verdict end(et_request *r, et_truth *t, bool ok)
{
    et_judge_free(t);
    et_request_free(r);
    return ok ? PASS : FAIL;
}

/* ---- kinds of replies ---- */

/* One case in 3. */
verdict prop_judge_reply(gen *g)
{
    et_request r;
    et_truth t;
    et_judgement j;
    et_reply refused = { ET_REPLY_REFUSED, 0, NULL, "because" }, unsupported = { ET_REPLY_UNSUPPORTED, 0, NULL, "" }, empty = { ET_REPLY_OK, 0,
            NULL, "" };
    const int is = drawn(g, &r, &t, kit_op(g), false);

    if (is <= 0)
        return is < 0 ? FAIL : SKIP;
    bool ok = gen_check(g, et_judge_reply(&j, &r, &t, &unsupported) == ET_OK, "status") && kit_is(g, &j, ET_VERDICT_UNSUPPORTED, "unsupported");
    ok = ok && gen_check(g, et_judge_reply(&j, &r, &t, &refused) == ET_OK, "status");
    ok = ok && kit_is(g, &j, t.validity == ET_VALID ? ET_VERDICT_WRONGLY_REFUSED : t.validity == ET_INVALID
            ? ET_VERDICT_CORRECTLY_ROUNDED : ET_VERDICT_WITHIN_BOUND,
                      "refused");
    ok = ok && gen_check(g, (t.validity == ET_VALID) == (strstr(j.text, "because") != NULL) && (t.validity == ET_VALID || j.text[0] == '\0'),
            "text: %s", j.text);
    ok = ok && gen_check(g, et_judge_reply(&j, &r, &t, &empty) == ET_OK, "status");
    ok = ok && kit_is(g, &j, t.validity == ET_INVALID ? ET_VERDICT_WRONGLY_ACCEPTED : t.count > 0 || t.validity == ET_VALID
            ? ET_VERDICT_WRONG : ET_VERDICT_WITHIN_BOUND,
                      "no numbers");
    if (ok && t.validity != ET_VALID && t.count == 0) {
        const double x[2] = { 1, gen_chance(g, 2) ? NAN : INFINITY };
        j = kit_judge(g, &r, &t, x, 1);
        ok = kit_is(g, &j, t.validity == ET_INVALID ? ET_VERDICT_WRONGLY_ACCEPTED : ET_VERDICT_WITHIN_BOUND, "any number");
        j = kit_judge(g, &r, &t, x, 2);
        ok = ok && kit_is(g, &j, t.validity == ET_INVALID ? ET_VERDICT_WRONGLY_ACCEPTED : ET_VERDICT_WITHIN_BOUND, "no number");
    }
    ok = ok && gen_check(g, !et_judge_bad(j.verdict) || j.text[0], "no sentence");
    return end(&r, &t, ok);
}

/* ---- numbers ---- */

static double moved(double want, double bound, double by)
{
    const double x = want + bound * by;

    return isfinite(x) ? x : want;
}

static bool near_numbers(gen *g, const et_request *r, const et_truth *t, double *x, size_t i)
{
    static const double by[] = { 0.25, 0.9, 1.0, 1.2, 4, 1000, 0x1p19, 0x1p21, 0x1p30 };
    bool ok = true;

    for (size_t k = 0; ok && k < sizeof by / sizeof *by; k++) {
        x[i] = moved(t->want[i], t->bound[i], gen_chance(g, 2) ? -by[k] : by[k]);
        const double off = fabs(x[i] - t->want[i]) / t->bound[i];
        const et_judgement j = kit_judge(g, r, t, x, t->count);
        if (fabs(off - 1) < 1e-9 || fabs(off / 0x1p20 - 1) < 1e-9 || !isfinite(off))
            continue;
        ok = kit_is(g, &j, x[i] == t->want[i] ? ET_VERDICT_CORRECTLY_ROUNDED : off <= 1 ? ET_VERDICT_WITHIN_BOUND : off <= 0x1p20
                ? ET_VERDICT_INACCURATE : ET_VERDICT_WRONG,
                    "moved")
            && gen_check(g, fabs(j.ratio - off) <= 1e-6 * off, "ratio %g, not %g", j.ratio, off);
        if (off > 1)
            ok = ok && gen_check(g, j.at == i && j.got == x[i] && j.want == t->want[i] && j.bound == t->bound[i] && j.text[0], "at %zu: %s", j.at,
                    j.text);
        else
            ok = ok && gen_check(g, j.text[0] == '\0', "%s", j.text);
    }
    x[i] = t->want[i];
    return ok;
}

/* One unit of the last place is never too much. */
static bool next_number(gen *g, const et_request *r, const et_truth *t, double *x, size_t i)
{
    x[i] = nextafter(t->want[i], gen_chance(g, 2) ? -INFINITY : INFINITY);
    const double off = fabs(x[i] - t->want[i]) / t->bound[i];
    const et_judgement j = kit_judge(g, r, t, x, t->count);
    x[i] = t->want[i];
    return off > 1 || off != off || kit_is(g, &j, ET_VERDICT_WITHIN_BOUND, "one unit");
}

static bool equal_number(gen *g, const et_request *r, const et_truth *t, double *x, size_t i)
{
    x[i] = t->want[i] == 0 ? -t->want[i] : nextafter(t->want[i], INFINITY);
    const et_judgement j = kit_judge(g, r, t, x, t->count);
    const bool ok = kit_is(g, &j, t->want[i] == 0 ? ET_VERDICT_CORRECTLY_ROUNDED : ET_VERDICT_WRONG, "to be equal");
    x[i] = t->want[i];
    return ok;
}

/* Where numbers of an edited curve's points stand: the head is not judged by its bounds alone. */
static bool alone(const et_request *r, const et_truth *t, size_t i)
{
    const bool curve = r->op == ET_OP_CURVE_INSERT || r->op == ET_OP_CURVE_ELEVATE;

    if (!kit_editing(r->op))
        return true;
    const size_t ku = (size_t)t->want[curve ? 1 : 2], kv = curve ? 0 : (size_t)t->want[3 + ku], head = curve ? 3 + ku : 5 + ku + kv;
    return i >= head && i < head + 3 * (size_t)t->want[head - 1];
}

/* One case in 4. */
verdict prop_judge_reply_perturbed(gen *g)
{
    const et_request_op op = kit_op(g);
    et_request r;
    et_truth t;
    const int is = kit_structured(op) ? 0 : drawn(g, &r, &t, op, true);

    if (is <= 0)
        return is < 0 ? FAIL : SKIP;
    double *x = malloc((t.count + 1) * sizeof *x);
    memcpy(x, t.want, t.count * sizeof *x);
    x[t.count] = 0;
    const size_t i = gen_upto(g, t.count - 1);
    et_judgement j = kit_judge(g, &r, &t, x, t.count);
    bool ok = kit_is(g, &j, ET_VERDICT_CORRECTLY_ROUNDED, "right");
    j = kit_judge(g, &r, &t, x, t.count + 1);
    ok = ok && kit_is(g, &j, ET_VERDICT_WRONG, "one number more");
    j = kit_judge(g, &r, &t, x, t.count - 1);
    ok = ok && kit_is(g, &j, ET_VERDICT_WRONG, "one number less");
    if (t.other) {
        j = kit_judge(g, &r, &t, t.other, t.count);
        ok = ok && kit_is(g, &j, ET_VERDICT_CORRECTLY_ROUNDED, "the other limit");
    } else if (isinf(t.bound[i])) {
        x[i] = 7;
        j = kit_judge(g, &r, &t, x, t.count);
        ok = ok && gen_check(g, j.verdict <= ET_VERDICT_WITHIN_BOUND, "a free number: %s", j.text);
    } else if (alone(&r, &t, i)) {
        ok = ok && (t.bound[i] > 0 ? near_numbers(g, &r, &t, x, i) && next_number(g, &r, &t, x, i) : equal_number(g, &r, &t, x, i));
        x[i] = gen_chance(g, 2) ? NAN : gen_chance(g, 2) ? INFINITY : -INFINITY;
        j = kit_judge(g, &r, &t, x, t.count);
        ok = ok && kit_is(g, &j, ET_VERDICT_NON_FINITE, "no number") && gen_check(g, j.at == i && j.text[0], "at %zu: %s", j.at, j.text);
    } else {
        x[i] += 1;
        j = kit_judge(g, &r, &t, x, t.count);
        ok = ok && gen_check(g, et_judge_bad(j.verdict) || i + 1 >= (size_t)t.count || t.want[i] != x[i] - 1 || i > t.count - 1 - (size_t)t.want[0],
                "%zu: %s", i,
                             et_judge_name(j.verdict));
    }
    free(x);
    return end(&r, &t, ok);
}

/* The answer to another request is right only as far as it is the same. */
/* One case in 4. */
verdict prop_judge_reply_neighbour(gen *g)
{
    const et_hello hello = et_answer_hello(1);
    const et_request_op op = kit_op(g);
    et_request r, s;
    et_truth t, v;
    double worst = 0;
    const int is = kit_structured(op) || kit_editing(op) ? 0 : drawn(g, &r, &t, op, true);

    if (is <= 0)
        return is < 0 ? FAIL : SKIP;
    if (et_campaign_vary(&s, &r, gen_upto(g, 1000), gen_upto(g, 1000), &hello) != ET_OK)
        return end(&r, &t, true);
    bool ok = gen_check(g, et_judge_truth(&v, &s) == ET_OK, "neighbour");
    if (ok && v.count == t.count && !t.other) {
        const et_judgement j = kit_judge(g, &r, &t, v.want, v.count);
        bool equal = true, finite = true;
        for (size_t i = 0; i < t.count; i++) {
            const double off = fabs(v.want[i] - t.want[i]);
            equal = equal && v.want[i] == t.want[i];
            finite = finite && (isfinite(v.want[i]) || isinf(t.bound[i]));
            worst = fmax(worst, off == 0 || isinf(t.bound[i]) ? 0 : t.bound[i] == 0 ? INFINITY : off / t.bound[i]);
        }
        ok = kit_is(g, &j, !finite ? ET_VERDICT_NON_FINITE : equal ? ET_VERDICT_CORRECTLY_ROUNDED : worst <= 1 ? ET_VERDICT_WITHIN_BOUND
                                : worst <= 0x1p20 ? ET_VERDICT_INACCURATE : ET_VERDICT_WRONG, "the neighbour's");
        gen_label(g, et_judge_name(j.verdict));
    }
    if (ok)
        et_judge_free(&v);
    et_request_free(&s);
    return end(&r, &t, ok);
}

/* ---- limits ---- */

/* A bilinear surface torn along both middles: each of four limits is right where any is asked for, a mixture of two is not. */
verdict prop_judge_reply_limits(gen *g)
{
    static const char line[] = "surface_point 1 1 6 0 0 0x1p-1 0x1p-1 1 1 6 0 0 0x1p-1 0x1p-1 1 1 16 "
                               "0 0 0 0 1 0 0 1 1 0 2 0  1 0 0 1 1 2 1 1 3 1 2 0  1 0 0 1 1 4 1 1 5 1 2 0  2 0 0 2 1 0 2 1 0 2 2 0 0 0x1p-1 0x1p-1 ";
    static const char *const words[] = { "any", "right", "left" };
    static const double z[2][2] = { { 5, 4 }, { 3, 2 } };       /* from right or left in u, in v */
    const size_t a = gen_upto(g, 2), b = gen_upto(g, 2), u = gen_upto(g, 1), v = gen_upto(g, 1);
    char text[600];
    et_truth t;

    strcpy(text, line);
    strcat(strcat(strcat(text, words[a]), " "), words[b]);
    et_request r = kit_parse(text);
    bool ok = gen_check(g, et_judge_truth(&t, &r) == ET_OK && t.validity == ET_VALID && t.count == 3, "truth");
    const double x[3] = { 1, 1, z[u][v] };
    const bool right = (a == 0 || u == (a == 2)) && (b == 0 || v == (b == 2));
    et_judgement j = kit_judge(g, &r, &t, x, 3);
    ok = ok && kit_is(g, &j, right ? ET_VERDICT_CORRECTLY_ROUNDED : ET_VERDICT_WRONG, text);
    ok = ok && gen_check(g, t.want[2] == z[a == 2][b == 2] && (t.other != NULL) == (a == 0 || b == 0), "limits");
    ok = ok && (!t.other || gen_check(g, t.other[2] == z[a != 1][b != 1], "other limit"));
    const double y[3] = { 1, 1, 6 };
    j = kit_judge(g, &r, &t, y, 3);
    ok = ok && kit_is(g, &j, ET_VERDICT_WRONG, "none of them");
    return end(&r, &t, ok);
}

/* ---- curves and surfaces ---- */

/* Weights times a factor; no weights for equal ones, and equal ones for none. */
/* One case in 3. */
verdict prop_judge_reply_weights(gen *g)
{
    static const et_request_op ops[] = { ET_OP_CURVE_INSERT, ET_OP_CURVE_ELEVATE, ET_OP_SURFACE_INSERT, ET_OP_SURFACE_ELEVATE };
    static const double factors[] = { 2, 0.5, 3, 0x1.5p-20, 1e10 };
    const size_t which = gen_upto(g, 3);
    et_request r;
    et_truth t;
    const int is = drawn(g, &r, &t, ops[which], true);

    if (is <= 0)
        return is < 0 ? FAIL : SKIP;
    const size_t ku = (size_t)t.want[which < 2 ? 1 : 2], kv = which < 2 ? 0 : (size_t)t.want[3 + ku], head = which < 2 ? 3 + ku : 5 + ku + kv;
    const size_t n = (size_t)t.want[head - 1], at = head + 3 * n, nw = (size_t)t.want[at];
    double *x = calloc(t.count + n, sizeof *x);
    memcpy(x, t.want, t.count * sizeof *x);
    bool ok = gen_check(g, t.count == at + 1 + nw, "the parts of it"), tiny = false;
    const double f = factors[gen_upto(g, 4)];
    for (size_t i = 0; i < n; i++) {
        tiny = tiny || (nw && (t.want[at + 1 + i] < 1e-290 || t.want[at + 1 + i] > 1e290));
        x[at + 1 + i] = f * (nw ? t.want[at + 1 + i] : 1);
    }
    x[at] = (double)n;
    et_judgement j = kit_judge(g, &r, &t, x, at + 1 + n);
    ok = ok && (tiny || gen_check(g, !et_judge_bad(j.verdict), "times %g: %s, %s", f, et_judge_name(j.verdict), j.text));
    if (!tiny && n > 1) {
        const size_t i = gen_upto(g, n - 1);
        /* A hundredth of the weight must be more than its bound, which is that of the heaviest near it; if the greatest of all is altered, the others
         * are judged by a factor that is off by a hundredth. */
        bool seen = nw == 0;
        for (size_t k = 0; k < nw; k++)
            seen = seen || 0.009 * t.want[at + 1 + k] > 2 * t.bound[at + 1 + k];
        for (size_t k = 0; k < nw; k++)
            seen = seen && (k != i || 0.009 * t.want[at + 1 + k] > 2 * t.bound[at + 1 + k]);
        for (size_t k = 0; k < nw && seen; k++)
            seen = k == i || t.want[at + 1 + k] > 1.02 * t.want[at + 1 + i] || 0.009 * t.want[at + 1 + k] > 2 * t.bound[at + 1 + k];
        x[at + 1 + i] *= 1.01;
        j = kit_judge(g, &r, &t, x, at + 1 + n);
        ok = ok && (!seen || gen_check(g, et_judge_bad(j.verdict), "one of the weights is another"));
        gen_label(g, nw ? "weights" : "equal weights for none");
    }
    x[at] = 0;
    bool equal = true;
    for (size_t i = 1; i < nw; i++)
        equal = equal && t.want[at + 1 + i] == t.want[at + 1];
    j = kit_judge(g, &r, &t, x, at + 1);
    ok = ok && gen_check(g, !equal || !et_judge_bad(j.verdict), "no weights for equal ones: %s", j.text);
    free(x);
    return end(&r, &t, ok);
}

static et_reply shape_reply(const et_curve *c, const double *ahead)
{
    et_reply reply = { ET_REPLY_OK, 0, NULL, "" };

    if ((ahead && et_reply_put(&reply, ahead, 1) != ET_OK) || et_reply_put_curve(&reply, c) != ET_OK)
        abort();
    return reply;
}

static et_judgement judge_curve(gen *g, const et_request *r, const et_truth *t, const et_curve *c, double ahead)
{
    et_judgement j = { ET_VERDICTS, 0, 0, 0, 0, 0, "" };
    et_reply reply = shape_reply(c, &ahead);

    gen_check(g, et_judge_reply(&j, r, t, &reply) == ET_OK, "not judged");
    et_reply_free(&reply);
    return j;
}

/* A curve, a knot put into it r times and taken out again: what is right, what is not quite, and what is not. */
verdict prop_judge_reply_removal(gen *g)
{
    const size_t times = gen_between(g, 1, 2), asked = times + gen_upto(g, 1);
    const double x = 0x1p-2 * (double)gen_between(g, 1, 3), size = ldexp(1, (int)gen_upto(g, 20) - 10), tol = gen_chance(g, 2) ? 0 : size * 0x1p-30;
    double u[] = { 0, 0, 0, 0, 1, 1, 1, 1 }, w[4] = { 1, 2, 0.5, 1 };
    et_vec3 P[4];
    et_curve c = { 3, 4, u, P, gen_chance(g, 2) ? w : NULL }, more;
    et_request r;
    et_truth t;

    for (size_t i = 0; i < 4; i++)
        P[i] = (et_vec3){ size * gen_real(g, -1, 1), size * gen_real(g, 0.5, 1), size * gen_real(g, -1, 1) };
    if (et_exact_curve_insert(&more, &c, x, times) != ET_OK || et_request_new(&r, ET_OP_CURVE_REMOVE) != ET_OK)
        return FAIL;
    bool ok = et_request_set(&r, 0, 3, NULL) == ET_OK && et_request_set(&r, 1, more.n + 4, more.u) == ET_OK && et_request_set(&r, 2, more.n,
            &more.points->x) == ET_OK
              && et_request_set(&r, 3, c.weights ? more.n : 0, more.weights) == ET_OK && et_request_set(&r, 4, 0, &x) == ET_OK && et_request_set(&r,
                      5, asked, NULL) == ET_OK
              && et_request_set(&r, 6, 0, &tol) == ET_OK && gen_check(g, et_judge_truth(&t, &r) == ET_OK && t.validity == ET_VALID, "truth");
    if (!ok) {
        et_curve_free(&more);
        et_request_free(&r);
        return FAIL;
    }
    et_judgement j = judge_curve(g, &r, &t, &c, (double)times);
    ok = gen_check(g, !et_judge_bad(j.verdict), "all of it: %s", j.text);
    j = judge_curve(g, &r, &t, &c, (double)times - 1);
    ok = ok && kit_is(g, &j, ET_VERDICT_WRONG, "t that is not true");
    j = judge_curve(g, &r, &t, &more, 0);
    ok = ok && gen_check(g, et_judge_bad(j.verdict) == (t.want[0] > 0 && tol > 0) || (t.want[0] == 0 && !et_judge_bad(j.verdict)),
            "nothing of it: %s, t0 %g", j.text, t.want[0]);
    P[1].x += size * 0x1p-8;
    j = judge_curve(g, &r, &t, &c, (double)times);
    ok = ok && kit_is(g, &j, ET_VERDICT_WRONG, "another curve");
    P[1].x -= size * 0x1p-8;
    P[1].x += size * 0x1p-38;
    j = judge_curve(g, &r, &t, &c, (double)times);
    ok = ok && kit_is(g, &j, tol > 0 ? ET_VERDICT_WITHIN_BOUND : ET_VERDICT_INACCURATE, "a curve nearby");
    P[1].x -= size * 0x1p-38;
    u[4] = nextafter(1, 0);
    j = judge_curve(g, &r, &t, &c, (double)times);
    ok = ok && kit_is(g, &j, ET_VERDICT_WRONG, "another knot");
    u[4] = 1;
    P[2].y = NAN;
    j = judge_curve(g, &r, &t, &c, (double)times);
    ok = ok && kit_is(g, &j, ET_VERDICT_NON_FINITE, "no number");
    P[2].y = 1;
    w[2] = -1;
    if (c.weights) {
        j = judge_curve(g, &r, &t, &c, (double)times);
        ok = ok && kit_is(g, &j, ET_VERDICT_WRONG, "a negative weight");
    }
    j = kit_judge(g, &r, &t, t.want, t.count - 1);
    ok = ok && kit_is(g, &j, ET_VERDICT_WRONG, "a number is missing");
    j = kit_judge(g, &r, &t, t.want, t.count);
    ok = ok && kit_is(g, &j, ET_VERDICT_CORRECTLY_ROUNDED, "the exact one");
    et_curve_free(&more);
    return end(&r, &t, ok);
}

/* The same of surfaces: inserted by the exact layer, removed by the fast one; then a control point is moved. */
/* One case in 6. */
verdict prop_judge_reply_removal_surface(gen *g)
{
    et_request r;
    et_truth t;
    et_reply reply;
    et_judgement j;
    const int is = drawn(g, &r, &t, ET_OP_SURFACE_REMOVE, true);

    if (is <= 0)
        return is < 0 ? FAIL : SKIP;
    bool ok = gen_check(g, et_answer_fast(&reply, &r) == ET_OK && reply.kind == ET_REPLY_OK && et_judge_reply(&j, &r, &t, &reply) == ET_OK, "answer")
              && gen_check(g, !et_judge_bad(j.verdict), "%s", j.text);
    const size_t ku = (size_t)reply.x[3], kv = (size_t)reply.x[4 + ku], head = 6 + ku + kv, n = (size_t)reply.x[head - 1], i = head + gen_upto(g,
            3 * n - 1);
    double most = 0;
    for (size_t k = 0; k < 3 * n; k++)
        most = fmax(most, fabs(reply.x[head + k]));
    const double kept = reply.x[i], by = 0x1p10 * r.arg[9].x[0] + most;
    /* far enough that even of a high degree, or beside a heavy weight, something is seen of it: the verdict is bad, or it has hardly any weight */
    reply.x[i] = kept + by * 0x1p20;
    ok = ok && gen_check(g, et_judge_reply(&j, &r, &t, &reply) == ET_OK, "judged");
    ok = ok && (r.arg[5].count > 0 || !isfinite(reply.x[i]) || most == 0 || gen_check(g, et_judge_bad(j.verdict), "a point moved from %a to %a: %s",
            kept, reply.x[i], j.text));
    reply.x[i] = NAN;
    ok = ok && gen_check(g, et_judge_reply(&j, &r, &t, &reply) == ET_OK, "judged") && kit_is(g, &j, ET_VERDICT_NON_FINITE, "no number");
    et_reply_free(&reply);
    return end(&r, &t, ok);
}

/* ---- nearest points, approximations ---- */

verdict prop_judge_reply_nearest(gen *g)
{
    et_request r;
    et_truth t;
    et_curve c;
    et_vec3 C = { 0, 0, 0 };
    const int is = drawn(g, &r, &t, ET_OP_CURVE_NEAREST, true);

    if (is <= 0)
        return is < 0 ? FAIL : SKIP;
    const et_vec3 *P = (const et_vec3 *)r.arg[4].x;
    double x[3] = { t.want[0], t.want[1], 0 };
    et_judgement j = kit_judge(g, &r, &t, x, 2);
    bool ok = et_request_curve(&c, &r, 0) == ET_OK && kit_is(g, &j, ET_VERDICT_CORRECTLY_ROUNDED, "right");
    j = kit_judge(g, &r, &t, x, 3);
    ok = ok && kit_is(g, &j, ET_VERDICT_WRONG, "a number more");
    const double lo = c.u[c.p], hi = c.u[c.n];
    x[0] = gen_chance(g, 2) ? nextafter(hi, INFINITY) : nextafter(lo, -INFINITY);
    j = kit_judge(g, &r, &t, x, 2);
    ok = ok && kit_is(g, &j, ET_VERDICT_WRONG, "outside");
    x[0] = NAN;
    j = kit_judge(g, &r, &t, x, 2);
    ok = ok && kit_is(g, &j, ET_VERDICT_NON_FINITE, "no parameter");
    x[0] = t.want[0];
    x[1] = INFINITY;
    j = kit_judge(g, &r, &t, x, 2);
    ok = ok && kit_is(g, &j, ET_VERDICT_NON_FINITE, "no distance");
    x[1] = t.want[1] + 3 * t.bound[1];
    j = kit_judge(g, &r, &t, x, 2);
    ok = ok && gen_check(g, et_judge_bad(j.verdict) || !isfinite(x[1]) || x[1] == t.want[1], "a false distance: %s", et_judge_name(j.verdict));
    /* any parameter, its distance told as it is */
    x[0] = gen_chance(g, 2) ? lo : lo + (hi - lo) * gen_real(g, 0, 1);
    ok = ok && et_exact_curve_point(&C, &c, x[0]) == ET_OK;
    x[1] = et_exact_vec3_distance(C, *P);
    j = kit_judge(g, &r, &t, x, 2);
    const double off = (x[1] - t.want[1]) / t.bound[1];
    if (off > 1.001 || off < 0.999)
        ok = ok && gen_check(g, et_judge_bad(j.verdict) == (off > 1), "%g bounds off: %s %s", off, et_judge_name(j.verdict), j.text);
    gen_label(g, off > 1 ? "far" : "near");
    return end(&r, &t, ok);
}

verdict prop_judge_reply_approximate(gen *g)
{
    et_request r;
    et_truth t;
    et_reply reply;
    et_judgement j;
    const int is = drawn(g, &r, &t, ET_OP_APPROXIMATE, false);

    if (is <= 0 || t.validity != ET_VALID)
        return is < 0 ? FAIL : is == 0 ? SKIP : (end(&r, &t, true), SKIP);
    bool ok = gen_check(g, et_answer_fast(&reply, &r) == ET_OK && et_judge_reply(&j, &r, &t, &reply) == ET_OK, "answer") && kit_is(g, &j,
            ET_VERDICT_WITHIN_BOUND, "right");
    if (!gen_check(g, reply.kind == ET_REPLY_OK, "refused: %s", reply.reason))
        return end(&r, &t, false);
    const size_t ku = (size_t)reply.x[2], at[] = { 0, 1, 2, 3, 4 + ku };
    const size_t k = at[gen_upto(g, 4)];
    const double kept = reply.x[k];
    reply.x[k] = kept + 1;
    ok = ok && gen_check(g, et_judge_reply(&j, &r, &t, &reply) == ET_OK, "judged");
    ok = ok && kit_is(g, &j, ET_VERDICT_WRONG, "another size, or decreasing");
    reply.x[k] = kept;
    reply.x[3 + (size_t)r.arg[0].count] = -1;       /* the domain begins at u_p */
    ok = ok && gen_check(g, et_judge_reply(&j, &r, &t, &reply) == ET_OK, "judged") && kit_is(g, &j, ET_VERDICT_WRONG, "another domain");
    reply.x[3 + (size_t)r.arg[0].count] = 0;
    reply.x[reply.count - 2] = NAN;
    ok = ok && gen_check(g, et_judge_reply(&j, &r, &t, &reply) == ET_OK, "judged") && kit_is(g, &j, ET_VERDICT_NON_FINITE, "no number");
    reply.count--;
    ok = ok && gen_check(g, et_judge_reply(&j, &r, &t, &reply) == ET_OK, "judged") && kit_is(g, &j, ET_VERDICT_WRONG, "a number less");
    et_reply_free(&reply);
    return end(&r, &t, ok);
}

/* ---- sentences ---- */

#define CURVE "2 6 0 0 0 1 1 1 3 0 0 0 1 2 0 4 0 1 "
#define SURFACE "1 1 4 0 0 1 1 4 0 0 1 1 4 0 0 0 0 1 0 1 0 1 1 1 1 "
static const struct { const char *line; size_t at; const char *says; } sentences[] = {
    { "span 2 6 0 0 0 1 1 1 0", 0, "the span is " }, { "multiplicity 1 0 0", 0, "the multiplicity is " }, { "greville 2 6 0 0 0 1 1 1", 1,
      "Greville point 1 is " },
    { "basis 2 6 0 0 0 1 1 1 0x1p-2 any", 2, "N_2 is " }, { "basis_ders 2 6 0 0 0 1 1 1 0x1p-2 any 1", 4, "the 1st derivative of N_1 is " },
    { "curve_point " CURVE "0 0x1p-2 any", 1, "y of the point is " }, { "curve_ders " CURVE "0 0x1p-2 any 3", 6, "x of the 2nd derivative is " },
    { "curve_ders " CURVE "0 0x1p-2 any 13", 3 * 11 + 2, "z of the 11th derivative is " }, { "curve_ders " CURVE "0 0x1p-2 any 22", 3 * 21,
      "x of the 21st derivative is " },
    { "curve_ders " CURVE "0 0x1p-2 any 23", 3 * 23, "x of the 23rd derivative is " },
    { "surface_point " SURFACE "0 0x1p-2 0x1p-2 any any", 2, "z of the point is " }, { "surface_ders " SURFACE "0 0x1p-2 0x1p-2 any any 3", 3,
      "x of S_u is " },
    { "surface_ders " SURFACE "0 0x1p-2 0x1p-2 any any 3", 13, "y of S_uv is " }, { "surface_ders " SURFACE "0 0x1p-2 0x1p-2 any any 3", 24,
      "x of S_uvv is " },
    { "surface_normal " SURFACE "0 0x1p-2 0x1p-2", 0, "x of the normal is " }, { "parameters chord 3 0 0 0 1 0 0 4 0 0", 1, "parameter 1 is " },
    { "parameters_grid chord 2 2 4 0 0 0 1 0 0 4 0 0 5 5 5", 1, "parameter 1 along i is " },
      { "parameters_grid chord 2 2 4 0 0 0 1 0 0 4 0 0 5 5 5", 3, "parameter 1 along j is " },
    { "knots uniform 2 4 2 0 1", 3, "knot 3 is " }, { "fit_curve 1 4 0 0 1 1 2 0 1 2 0 0 0 1 1 1", 4, "y of control point 1 is " },
    { "net_counts 3 4", 1, "NOV is " }, { "net_class 3 4 0 0 0", 0, "the class is " }, { "net_node 3 4 3", 2, "j is " },
    { "surface_error " SURFACE "0 1 0 1 0 1 1 1 1", 0, "the sum of distances is " }, { "surface_error " SURFACE "0 1 0 1 0 1 1 1 1", 1,
      "the greatest distance is " },
    { "seam_gap " SURFACE "0 " SURFACE "0 1", 0, "the gap is " }, { "curve_insert " CURVE "0 0x1p-1 1", 8 + 2 + 3, "x of control point 1 is " },
    { "curve_insert " CURVE "3 1 2 1 0x1p-1 1", 2, "knot 0 is " }, { "curve_insert " CURVE "3 1 2 1 0x1p-1 1", 9 + 1 + 12 + 4, "weight 3 is " },
    { "surface_insert " SURFACE "0 v 0x1p-1 1", 3 + 4 + 1, "v-knot 0 is " }, { "surface_insert " SURFACE "0 v 0x1p-1 1", 2 + 5 + 6 + 1 + 4,
      "y of control point 1 is " },
};

/* A number 1 too great is called by its name. */
verdict prop_judge_reply_text(gen *g)
{
    const size_t k = gen_upto(g, sizeof sentences / sizeof *sentences - 1);
    et_request r = kit_parse(sentences[k].line);
    et_truth t;
    const bool made = gen_check(g, et_judge_truth(&t, &r) == ET_OK && sentences[k].at < t.count, "%s", sentences[k].line);
    bool ok = made;

    if (made) {
        double *x = malloc(t.count * sizeof *x);
        memcpy(x, t.want, t.count * sizeof *x);
        x[sentences[k].at] += 1;
        const et_judgement j = kit_judge(g, &r, &t, x, t.count);
        ok = kit_is(g, &j, ET_VERDICT_WRONG, sentences[k].line)
            && gen_check(g, strncmp(j.text, sentences[k].says, strlen(sentences[k].says)) == 0 && strstr(j.text, "should be"), "%s: %s",
                    sentences[k].says, j.text);
        free(x);
    }
    return made ? end(&r, &t, ok) : FAIL;
}

/* Sizes of edited curves and surfaces that are not what they should be. */
verdict prop_judge_reply_sizes(gen *g)
{
    et_request r = kit_parse("curve_insert " CURVE "0 0x1p-1 1"), s = kit_parse("curve_elevate " CURVE "0 1");
    et_truth t, v;
    et_judgement j;
    bool ok = gen_check(g, et_judge_truth(&t, &r) == ET_OK && et_judge_truth(&v, &s) == ET_OK, "truths");

    j = kit_judge(g, &r, &t, v.want, v.count);
    ok = ok && kit_is(g, &j, ET_VERDICT_WRONG, "elevated") && gen_check(g, strstr(j.text, "the degree is 3, should be 2") != NULL, "%s", j.text);
    j = kit_judge(g, &s, &v, t.want, t.count);
    ok = ok && kit_is(g, &j, ET_VERDICT_WRONG, "inserted") && gen_check(g, strstr(j.text, "the degree is 2, should be 3") != NULL, "%s", j.text);
    const double huge[] = { 1, 0x1p53, 0, 1 }, odd[] = { 2.5, 6 };
    j = kit_judge(g, &r, &t, huge, 4);
    ok = ok && kit_is(g, &j, ET_VERDICT_WRONG, "huge counts");
    j = kit_judge(g, &r, &t, odd, 2);
    ok = ok && kit_is(g, &j, ET_VERDICT_WRONG, "half a degree");
    et_judge_free(&v);
    et_request_free(&s);
    return end(&r, &t, ok);
}
