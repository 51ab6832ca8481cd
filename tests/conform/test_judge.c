/* conform/judge: names, verdicts that count, validity. */
#include "etalon/exact/exact.h"
#include "golden.h"
#include "judge_kit.h"
#include <stdio.h>

static const char *const verdicts[] = { "correctly_rounded", "within_bound", "inaccurate", "wrong", "non_finite", "wrongly_accepted",
        "wrongly_refused", "crash",
                                        "timeout", "nondeterministic", "unsupported" };

verdict prop_judge_name(gen *g)
{
    const size_t k = gen_upto(g, 20);
    const char *name = et_judge_name((et_verdict)k);

    if (k < sizeof verdicts / sizeof *verdicts)
        return gen_check(g, name && strcmp(name, verdicts[k]) == 0, "%zu: %s", k, name ? name : "null") ? PASS : FAIL;
    return gen_check(g, !name && !et_judge_name((et_verdict)-1), "%zu has a name", k) ? PASS : FAIL;
}

verdict prop_judge_validity_name(gen *g)
{
    const size_t k = gen_upto(g, 6);
    const char *name = et_judge_validity_name((et_validity)k);
    const char *want = k == 0 ? "valid" : k == 1 ? "implementation_defined" : k == 2 ? "invalid" : NULL;

    return gen_check(g, want ? name && strcmp(name, want) == 0 : !name, "%zu: %s", k, name ? name : "null")
            && gen_check(g, !et_judge_validity_name((et_validity)-1), "-1 has a name") ? PASS : FAIL;
}

verdict prop_judge_bad(gen *g)
{
    const size_t k = gen_upto(g, ET_VERDICTS - 1);
    const bool good = strcmp(verdicts[k], "correctly_rounded") == 0 || strcmp(verdicts[k], "within_bound") == 0 || strcmp(verdicts[k],
            "unsupported") == 0;

    return gen_check(g, et_judge_bad((et_verdict)k) == !good, "%s", verdicts[k]) ? PASS : FAIL;
}

verdict gold_judge_name(const row *r)
{
    const char *name = et_judge_name((et_verdict)row_size(r, 0));

    return r->nwant == 1 && strcmp(name ? name : "none", r->want[0]) == 0 ? PASS : FAIL;
}

verdict gold_judge_validity_name(const row *r)
{
    const char *name = et_judge_validity_name((et_validity)row_size(r, 0));

    return r->nwant == 1 && strcmp(name ? name : "none", r->want[0]) == 0 ? PASS : FAIL;
}

verdict gold_judge_bad(const row *r)
{
    return row_is_size(r, 0, (size_t)et_judge_bad((et_verdict)row_size(r, 0))) ? PASS : FAIL;
}

/* The words of the row as a line. */
verdict gold_judge_validity(const row *r)
{
    char line[4096] = "", reason[128];
    size_t length = 0;
    et_request request;
    et_message message = { "" };

    for (size_t k = 0; k < r->nargs; k++)
        length += (size_t)snprintf(line + length, length < sizeof line ? sizeof line - length : 0, "%s%s", k ? " " : "", r->arg[k]);
    if (length >= sizeof line || et_request_parse(&request, line, &message) != ET_OK)
        return FAIL;
    const et_validity validity = et_judge_validity(reason, &request);
    et_request_free(&request);
    return r->nwant == 1 && strcmp(et_judge_validity_name(validity), r->want[0]) == 0 && (validity == ET_VALID) == (reason[0] == '\0') ? PASS : FAIL;
}

/* ---- validity ---- */

static bool validity_is(gen *g, const et_request *r, et_validity want, const char *what)
{
    char reason[128];
    const et_validity validity = et_judge_validity(reason, r);

    return gen_check(g, validity == want, "%s: %s (%s)", what, et_judge_validity_name(validity), reason)
        && gen_check(g, (reason[0] == '\0') == (validity == ET_VALID) && strlen(reason) < 128, "%s: reason %s", what, reason);
}

/* A category says what its requests are: those of plain are valid, those of bad_input invalid. */
verdict prop_judge_validity(gen *g)
{
    const et_hello hello = et_answer_hello(1);
    const et_category category = gen_chance(g, 2) ? ET_CATEGORY_BAD_INPUT : ET_CATEGORY_PLAIN;
    const et_request_op op = (et_request_op)gen_upto(g, ET_OPS - 1);
    et_request r;

    if (!gen_check(g, et_campaign_draw(&r, op, category, gen_upto(g, 1 << 20), gen_upto(g, 1 << 10), &hello) == ET_OK, "not drawn"))
        return FAIL;
    gen_label(g, et_request_name(op));
    const bool ok = validity_is(g, &r, category == ET_CATEGORY_PLAIN ? ET_VALID : ET_INVALID, et_request_name(op));
    et_request_free(&r);
    return ok ? PASS : FAIL;
}

/* A number that is none makes every request invalid, wherever it stands; so does an infinite one. */
verdict prop_judge_validity_finite(gen *g)
{
    const et_request_op op = kit_op(g);
    et_request r;
    size_t n = 0, real[ET_REQUEST_ARGS], at;

    if (!kit_draw(g, &r, op, ET_CATEGORY_BAD_INPUT))
        return FAIL;
    for (size_t k = 0; et_request_argument(op, k); k++)
        if (r.arg[k].x)
            real[n++] = k;
    if (n > 0) {
        const size_t k = real[gen_upto(g, n - 1)];
        const et_request_kind kind = et_request_argument(op, k)->kind;
        at = gen_upto(g, (kind == ET_ARG_REAL ? 1 : kind == ET_ARG_REALS ? r.arg[k].count : 3 * r.arg[k].count) - 1);
        r.arg[k].x[at] = gen_chance(g, 2) ? NAN : gen_chance(g, 2) ? INFINITY : -INFINITY;
        gen_note(g, "%s, number %zu is %g", et_request_argument(op, k)->name, at, r.arg[k].x[at]);
    }
    const bool ok = n == 0 || validity_is(g, &r, ET_INVALID, et_request_name(op));
    et_request_free(&r);
    return ok ? n == 0 ? SKIP : PASS : FAIL;
}

/* One point or weight more or less than the knots, or the parameters, say. */
verdict prop_judge_validity_counts(gen *g)
{
    const et_request_op op = kit_op(g);
    et_request r;
    size_t n = 0, list[ET_REQUEST_ARGS];

    if (!kit_draw(g, &r, op, ET_CATEGORY_BAD_INPUT))
        return FAIL;
    for (size_t k = 0; et_request_argument(op, k); k++) {
        const et_request_shape *shape = et_request_argument(op, k);
        if (shape->kind == ET_ARG_POINTS || (shape->kind == ET_ARG_REALS && strncmp(shape->name, "weights", 7) == 0 && r.arg[k].count > 1))
            list[n++] = k;
    }
    if (n == 0 || op == ET_OP_PARAMETERS) {
        et_request_free(&r);
        return SKIP;
    }
    const size_t k = list[gen_upto(g, n - 1)], count = r.arg[k].count, width = et_request_argument(op, k)->kind == ET_ARG_POINTS ? 3 : 1;
    double *more = calloc((count + 1) * width, sizeof *more);
    for (size_t i = 0; i < count * width; i++)
        more[i] = r.arg[k].x[i];
    for (size_t i = count * width; i < (count + 1) * width; i++)
        more[i] = 1;
    bool ok = gen_check(g, et_request_set(&r, k, count + 1, more) == ET_OK, "set") && validity_is(g, &r, ET_INVALID, "one more");
    ok = ok && gen_check(g, et_request_set(&r, k, count - 1, more) == ET_OK, "set")
        && (count == 2 && width == 1 ? true : validity_is(g, &r, ET_INVALID, "one less"));
    free(more);
    et_request_free(&r);
    return ok ? PASS : FAIL;
}

/* Knots exchanged so that they decrease; a degree too high for the knots. */
verdict prop_judge_validity_knots(gen *g)
{
    const et_request_op op = kit_op(g);
    et_request r;
    bool ok = true;
    size_t tried = 0;

    if (!kit_draw(g, &r, op, ET_CATEGORY_BAD_INPUT))
        return FAIL;
    for (size_t k = 0; ok && et_request_argument(op, k); k++) {
        const char *name = et_request_argument(op, k)->name;
        if ((name[0] != 'u' && name[0] != 'v') || (name[1] != '\0' && name[1] != '_') || et_request_argument(op, k)->kind != ET_ARG_REALS)
            continue;
        double *u = r.arg[k].x;
        const size_t n = r.arg[k].count, i = gen_upto(g, n - 1), j = gen_upto(g, n - 1);
        if (u[i] != u[j]) {
            const double x = u[i], y = u[j];
            u[i] = y;
            u[j] = x;
            ok = validity_is(g, &r, ET_INVALID, "decreasing");
            u[i] = x;
            u[j] = y;
            tried++;
        }
        if (op != ET_OP_MULTIPLICITY) {
            const size_t of = strcmp(name, "u") == 0 ? (op == ET_OP_FIT_GRID) : name[1] == '\0' ? 1 + (op == ET_OP_FIT_GRID) : name[0] == 'u' ? 6 : 7;
            const size_t p = r.arg[of].count;
            r.arg[of].count = n / 2;
            ok = ok && validity_is(g, &r, ET_INVALID, "too few knots");
            r.arg[of].count = SIZE_MAX;
            ok = ok && validity_is(g, &r, ET_INVALID, "a huge degree");
            r.arg[of].count = p;
            tried++;
        }
    }
    et_request_free(&r);
    return !ok ? FAIL : tried ? PASS : SKIP;
}

/* Schoenberg and Whitney's condition is what the exact rank says. */
verdict prop_judge_validity_rank(gen *g)
{
    const size_t p = gen_between(g, 1, 3), inner = gen_upto(g, 3), nu = 2 * p + 2 + inner, n = nu - p - 1, m = gen_upto(g, n + 3);
    double u[16] = { 0 }, t[16];
    et_vec3 D[16] = { { 0, 0, 0 } }, P[16];
    et_exact_lsq lsq;
    et_request r;
    double last = 0;

    for (size_t i = 0; i < nu; i++) {
        if (i > p && i < n)
            last += (double)gen_upto(g, 1);
        u[i] = i >= n ? 4 : last;
    }
    for (size_t i = p + 1; i + p < n; i++)
        if (u[i] == u[i + p])            /* jumps are another matter */
            return SKIP;
    for (size_t k = 0; k < m; k++) {
        t[k] = (double)gen_upto(g, 16) / 4;
        D[k].x = (double)k;
    }
    if (et_request_new(&r, ET_OP_FIT_CURVE) != ET_OK)
        return FAIL;
    bool ok = et_request_set(&r, 0, p, NULL) == ET_OK && et_request_set(&r, 1, nu, u) == ET_OK && et_request_set(&r, 2, m, t) == ET_OK
              && et_request_set(&r, 3, m, &D->x) == ET_OK;
    const et_status status = m < n ? ET_ERANK : et_exact_fit_curve(P, n, &lsq, u, nu, p, t, D, m);
    char reason[128];
    const et_validity validity = et_judge_validity(reason, &r);
    ok = ok && gen_check(g, status == ET_OK || status == ET_ERANK, "%s", et_status_text(status));
    ok = ok && gen_check(g, (validity == ET_INVALID) == (status == ET_ERANK), "%s (%s), exactly: %s", et_judge_validity_name(validity), reason,
            et_status_text(status));
    gen_label(g, et_status_text(status));
    et_request_free(&r);
    return ok ? PASS : FAIL;
}

verdict prop_judge_free(gen *g)
{
    et_truth zero = { 0 }, t = { 0 };
    et_request r;

    et_judge_free(&zero);
    if (!kit_draw(g, &r, ET_OP_CURVE_DERS, ET_CATEGORY_SIZE))
        return FAIL;
    bool ok = gen_check(g, et_judge_truth(&t, &r) == ET_OK, "truth");
    et_judge_free(&t);
    ok = ok && gen_check(g, !t.want && !t.bound && !t.other && !t.other_bound && t.count == 0, "not zeroed");
    et_judge_free(&t);
    et_request_free(&r);
    return ok ? PASS : FAIL;
}
