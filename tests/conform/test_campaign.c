/* conform/campaign: cases, shrinking, relations and neighbours, against what their contracts say. */
#include "etalon/conform/campaign.h"
#include "etalon/conform/answer.h"
#include "golden.h"
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Everything, or a part of it. */
static et_hello draw_hello(gen *g)
{
    et_hello h;
    memset(&h, 0, sizeof h);
    snprintf(h.name, sizeof h.name, "test");
    h.degree = gen_chance(g, 3) ? (size_t)gen_between(g, 1, 8) : SIZE_MAX;
    h.order = gen_chance(g, 3) ? (size_t)gen_upto(g, 4) : SIZE_MAX;
    h.rational = !gen_chance(g, 3);
    const uint64_t sides = gen_chance(g, 3) ? gen_between(g, 1, 7) : 7;
    h.any = sides & 1;
    h.right = sides >> 1 & 1;
    h.left = sides >> 2 & 1;
    h.knot_tolerance = gen_chance(g, 4) ? (gen_upto(g, 1) ? 1e-10 : 0x1p-20) : 0.0;
    for (int op = 0; op < ET_OPS; op++) {
        h.op[op] = 1;
    }
    return h;
}

static char *text_of(const et_request *q)
{
    char *line = NULL;
    return et_request_print(&line, q) == ET_OK ? line : NULL;
}

/* The same line (numbers bit for bit, as hex floats tell NaN from NaN no more than the protocol does). */
static bool same_text(const et_request *a, const et_request *b)
{
    char *s = text_of(a), *t = text_of(b);
    const bool same = s && t && strcmp(s, t) == 0;
    free(s);
    free(t);
    return same;
}

/* ---- names ---- */

verdict prop_campaign_name(gen *g)
{
    static const char *const names[] = {"plain", "end_of_domain", "near_knots", "repeated_knots", "editing", "degenerate", "fit_failure", "seam",
                                        "inversion", "size", "extreme_scale", "weights", "degrees", "bad_input"};
    const unsigned k = (unsigned)gen_upto(g, ET_CATEGORIES + 2);
    const char *name = et_campaign_name((et_category)k);
    return gen_check(g, k < ET_CATEGORIES ? name && strcmp(name, names[k]) == 0 : name == NULL, "name of category %u", k) ? PASS : FAIL;
}

verdict gold_campaign_name(const row *r)
{
    const char *name = et_campaign_name((et_category)row_size(r, 0));
    return r->nwant == 1 && strcmp(name ? name : "none", r->want[0]) == 0 ? PASS : FAIL;
}

verdict prop_campaign_relation_name(gen *g)
{
    const size_t n = et_campaign_relations(), k = (size_t)gen_upto(g, n + 1);
    const char *name = et_campaign_relation_name(k);
    bool ok = gen_check(g, (name != NULL) == (k < n) && et_campaign_relation_name(SIZE_MAX) == NULL, "name of relation %zu", k);
    for (size_t i = 0; ok && i < k && k < n; i++) {
        ok = gen_check(g, strcmp(name, et_campaign_relation_name(i)) != 0, "relations %zu and %zu have one name", i, k);
    }
    return ok ? PASS : FAIL;
}

verdict prop_campaign_relations(gen *g)
{
    size_t n = 0;
    while (et_campaign_relation_name(n)) {
        n++;
    }
    return gen_check(g, et_campaign_relations() == n && n >= 20, "%zu relations, %zu names", et_campaign_relations(), n) ? PASS : FAIL;
}

verdict gold_campaign_relations(const row *r)
{
    return row_is_size(r, 0, et_campaign_relations()) ? PASS : FAIL;
}

/* ---- which cases there are ---- */

verdict prop_campaign_has(gen *g)
{
    const unsigned op = (unsigned)gen_upto(g, ET_OPS + 1), category = (unsigned)gen_upto(g, ET_CATEGORIES + 1);
    const int has = et_campaign_has((et_request_op)op, (et_category)category);
    bool ok = gen_check(g, has == 0 || has == 1, "neither yes nor no");
    if (op >= ET_OPS || category >= ET_CATEGORIES) {
        return ok && gen_check(g, !has, "cases of what is none") ? PASS : FAIL;
    }
    if (category == ET_CATEGORY_PLAIN || category == ET_CATEGORY_SIZE || category == ET_CATEGORY_BAD_INPUT) {
        ok = ok && gen_check(g, has, "%s has no %s cases", et_request_name((et_request_op)op), et_campaign_name((et_category)category));
    }
    et_hello h = et_answer_hello(1);
    et_request q = {ET_OPS, {{7, NULL}}};
    const et_status status = et_campaign_draw(&q, (et_request_op)op, (et_category)category, gen_upto(g, 9), gen_upto(g, 99), &h);
    ok = ok && gen_check(g, status == (has ? ET_OK : ET_EINVAL), "status %d", (int)status);
    ok = ok && gen_check(g, has || (q.op == ET_OPS && q.arg[0].count == 7), "the request was touched");
    if (status == ET_OK) {
        et_request_free(&q);
    }
    return ok ? PASS : FAIL;
}

verdict gold_campaign_has(const row *r)
{
    bool ok = true;
    for (int c = 0; c < ET_CATEGORIES && ok; c++) {
        ok = row_is_size(r, (size_t)c, (size_t)et_campaign_has(et_request_find(r->arg[0]), (et_category)c));
    }
    return ok ? PASS : FAIL;
}

/* ---- drawing ---- */

/* Places of arguments, restated from the table of docs/conformance.md: degrees and knots in pairs. */
static size_t bases_of(const et_request *q, size_t degree[4], size_t knots[4])
{
    static const struct { const char *degree, *knots; } pair[4] = {{"p", "u"}, {"q", "v"}, {"p_other", "u_other"}, {"q_other", "v_other"}};
    size_t n = 0;
    for (size_t i = 0; i < 4; i++) {
        size_t d = ET_REQUEST_ARGS, k = ET_REQUEST_ARGS;
        for (size_t a = 0; et_request_argument(q->op, a); a++) {
            const char *name = et_request_argument(q->op, a)->name;
            d = strcmp(name, pair[i].degree) == 0 ? a : d;
            k = strcmp(name, pair[i].knots) == 0 ? a : k;
        }
        if (d < ET_REQUEST_ARGS && k < ET_REQUEST_ARGS) {
            degree[n] = d;
            knots[n++] = k;
        }
    }
    return n;
}

static bool keeps_to(gen *g, const et_request *q, const et_hello *h)
{
    bool ok = true;
    for (size_t a = 0; et_request_argument(q->op, a); a++) {
        const char *name = et_request_argument(q->op, a)->name;
        const size_t n = q->arg[a].count;
        if (strcmp(name, "p") == 0 || strcmp(name, "q") == 0) {
            ok = ok && gen_check(g, n <= h->degree, "degree %zu of %zu", n, h->degree);
        } else if (strcmp(name, "d") == 0) {
            ok = ok && gen_check(g, n <= h->order, "order %zu of %zu", n, h->order);
        } else if (strncmp(name, "side", 4) == 0) {
            ok = ok && gen_check(g, n == 0 ? h->any : n == 1 ? h->right : h->left, "side %zu is not offered", n);
        } else if (strncmp(name, "weights", 7) == 0) {
            ok = ok && gen_check(g, h->rational || n == 0, "weights are not offered");
        }
    }
    if (q->op == ET_OP_CURVE_ELEVATE) {
        ok = ok && gen_check(g, q->arg[0].count + q->arg[4].count <= h->degree, "elevated beyond the degree");
    } else if (q->op == ET_OP_SURFACE_ELEVATE) {
        ok = ok && gen_check(g, q->arg[q->arg[6].count].count + q->arg[7].count <= h->degree, "elevated beyond the degree");
    }
    return ok;
}

/* No two different knots, nor the parameter of a curve and a knot, within the tolerance. */
static bool apart(gen *g, const et_request *q, const et_hello *h)
{
    size_t degree[4], knots[4];
    const size_t n = bases_of(q, degree, knots);
    bool ok = true;
    for (size_t k = 0; k < n; k++) {
        const et_request_value *u = &q->arg[knots[k]];
        const size_t p = q->arg[degree[k]].count;
        const double tolerance = h->knot_tolerance * (u->x[u->count - 1 - p] - u->x[p]);
        const bool x = n == 1 && et_request_argument(q->op, 4) && strcmp(et_request_argument(q->op, 4)->name, "x") == 0;
        for (size_t i = 0; i < u->count; i++) {
            ok = ok && gen_check(g, i == 0 || u->x[i] == u->x[i - 1] || u->x[i] - u->x[i - 1] > tolerance, "knots %zu and before are too close", i);
            ok = ok && gen_check(g, !x || q->arg[4].x[0] == u->x[i] || fabs(q->arg[4].x[0] - u->x[i]) > tolerance, "the parameter is too close");
        }
    }
    return ok;
}

/* Knots are so close that 2^-40 of the domain is more. */
static bool has_near(const et_request *q)
{
    size_t degree[4], knots[4];
    const size_t n = bases_of(q, degree, knots);
    bool found = false;
    for (size_t k = 0; k < n; k++) {
        const et_request_value *u = &q->arg[knots[k]];
        for (size_t i = 1; i < u->count; i++) {
            found = found || (u->x[i] > u->x[i - 1] && u->x[i] - u->x[i - 1] < 0x1p-40 * (u->x[u->count - 1] - u->x[0]));
            found = found || (u->x[i] == 0.0 && signbit(u->x[i]) && !signbit(u->x[i - 1])) || (u->x[i - 1] == 0.0 && signbit(u->x[i - 1]));
        }
    }
    return found || n == 0;
}

/* The category is what it says. */
static bool is_of(gen *g, const et_request *q, et_category category, const et_hello *h)
{
    char reason[128] = "";
    const et_validity validity = et_judge_validity(reason, q);
    const bool insert = q->op == ET_OP_CURVE_INSERT || q->op == ET_OP_SURFACE_INSERT;
    const bool fit = q->op == ET_OP_FIT_CURVE || q->op == ET_OP_FIT_GRID || q->op == ET_OP_FIT_SCATTERED;
    switch (category) {
    case ET_CATEGORY_PLAIN: return gen_check(g, validity == ET_VALID, "a plain case is not valid: %s", reason);
    case ET_CATEGORY_BAD_INPUT: return gen_check(g, validity == ET_INVALID, "bad input is not bad: %s", reason);
    case ET_CATEGORY_FIT_FAILURE: return true;
    case ET_CATEGORY_NEAR_KNOTS:
        if (h->knot_tolerance == 0.0 && q->op != ET_OP_MULTIPLICITY && !has_near(q)) {
            gen_label(g, "near knots: the parameter alone is near");
        }
        return gen_check(g, validity != ET_INVALID || insert || fit, "near knots are invalid: %s", reason);
    case ET_CATEGORY_END_OF_DOMAIN:
    case ET_CATEGORY_REPEATED_KNOTS: return gen_check(g, validity != ET_INVALID || insert || fit, "invalid: %s", reason);
    default: return gen_check(g, validity != ET_INVALID, "%s: invalid: %s", et_campaign_name(category), reason);
    }
}

verdict prop_campaign_draw(gen *g)
{
    const et_hello h = draw_hello(g);
    const et_request_op op = (et_request_op)gen_upto(g, ET_OPS - 1);
    et_category category = (et_category)gen_upto(g, ET_CATEGORIES - 1);
    const uint64_t seed = gen_chance(g, 4) ? ~gen_upto(g, 5) : gen_upto(g, 1000), number = gen_chance(g, 4) ? ~gen_upto(g, 99) : gen_upto(g, 999);
    if (!et_campaign_has(op, category) || (category == ET_CATEGORY_SIZE && !gen_chance(g, 4))) {
        category = ET_CATEGORY_PLAIN;
    }
    et_request q, again, read;
    const et_status status = et_campaign_draw(&q, op, category, seed, number, &h);
    if (status == ET_EINVAL) {
        gen_label(g, "hello leaves nothing");
        const bool elevate = op == ET_OP_CURVE_ELEVATE || op == ET_OP_SURFACE_ELEVATE;
        return gen_check(g, (category == ET_CATEGORY_WEIGHTS && !h.rational) || (elevate && h.degree < 2), "hello leaves enough") ? PASS : FAIL;
    }
    bool ok = gen_check(g, status == ET_OK && q.op == op, "status %d", (int)status);
    if (!ok) {
        return FAIL;
    }
    gen_label(g, et_campaign_name(category));
    ok = gen_check(g, et_campaign_draw(&again, op, category, seed, number, &h) == ET_OK, "drawn once only");
    if (ok) {
        ok = gen_check(g, same_text(&q, &again), "drawn twice: not the same");
        et_request_free(&again);
    }
    char *line = text_of(&q);
    et_message message;
    ok = ok && gen_check(g, line && strlen(line) < 200000 && et_request_parse(&read, line, &message) == ET_OK, "a line that cannot be read");
    if (ok) {
        ok = gen_check(g, same_text(&q, &read), "the line says another request");
        et_request_free(&read);
    }
    ok = ok && keeps_to(g, &q, &h) && is_of(g, &q, category, &h) && (category == ET_CATEGORY_BAD_INPUT || apart(g, &q, &h));
    gen_note(g, "%s, seed %llu, number %llu", et_campaign_name(category), (unsigned long long)seed, (unsigned long long)number);
    gen_note(g, "%.300s", line ? line : "");
    free(line);
    et_request_free(&q);
    return ok ? PASS : FAIL;
}

/* What takes turns: all degrees in 26 cases; the end of the domain and one ulp inside; full multiplicity; ratios of weights. */
verdict prop_campaign_draw_turns(gen *g)
{
    const et_hello h = et_answer_hello(1);
    const uint64_t seed = gen_upto(g, 1000);
    bool degree[26] = {false}, end = false, inside = false, outside = false, full = false, ratio = false, tiny = false, ok = true;
    static const et_category categories[4] = {ET_CATEGORY_DEGREES, ET_CATEGORY_END_OF_DOMAIN, ET_CATEGORY_REPEATED_KNOTS, ET_CATEGORY_WEIGHTS};
    for (uint64_t k = 0; k < 26 && ok; k++) {
        for (size_t c = 0; c < 4 && ok; c++) {
            et_request q;
            ok = gen_check(g, et_campaign_draw(&q, ET_OP_CURVE_POINT, categories[c], seed, k, &h) == ET_OK, "no case");
            if (!ok) {
                break;
            }
            const size_t p = q.arg[0].count, nu = q.arg[1].count;
            const double *u = q.arg[1].x, hi = u[nu - 1 - p], x = q.arg[4].x[0];
            degree[p % 26] = degree[p % 26] || categories[c] == ET_CATEGORY_DEGREES;
            end = end || (c == 1 && x == hi);
            inside = inside || (c == 1 && x < hi && nextafter(nextafter(nextafter(nextafter(x, 1e9), 1e9), 1e9), 1e9) >= hi);
            outside = outside || (c == 1 && x > hi);
            for (size_t i = p + 1; c == 2 && i + 2 * p + 1 < nu; i++) {
                full = full || (u[i] == u[i + p] && u[i] == x);
            }
            for (size_t i = 0; c == 3 && i < q.arg[3].count; i++) {
                ratio = ratio || q.arg[3].x[i] >= 1e15 * q.arg[3].x[0];
                tiny = tiny || (q.arg[3].x[i] > 0.0 && q.arg[3].x[i] < 1e-290);
            }
            et_request_free(&q);
        }
    }
    for (size_t p = 0; p < 26; p++) {
        ok = ok && gen_check(g, degree[p], "degree %zu is never drawn", p);
    }
    ok = ok && gen_check(g, end && inside && outside, "an end of the domain is never asked");
    ok = ok && gen_check(g, full && ratio && tiny, "full multiplicity %d, ratio 1e16 %d, tiny weights %d", full, ratio, tiny);
    return ok ? PASS : FAIL;
}

verdict gold_campaign_draw(const row *r)
{
    const et_hello h = et_answer_hello(1);
    et_category category = ET_CATEGORY_PLAIN;
    et_request q;
    while (et_campaign_name(category) && strcmp(et_campaign_name(category), r->arg[1]) != 0) {
        category = (et_category)(category + 1);
    }
    const uint64_t seed = strtoull(r->arg[2], NULL, 10), number = strtoull(r->arg[3], NULL, 10);
    if (et_campaign_draw(&q, et_request_find(r->arg[0]), category, seed, number, &h) != ET_OK) {
        return FAIL;
    }
    bool ok = true;
    const size_t counts = q.op == ET_OP_KNOTS ? 4 : r->nwant;
    for (size_t k = 0; k < counts && ok; k++) {
        ok = row_is_size(r, k, q.arg[k].count);
    }
    ok = ok && r->nwant == counts + (q.op == ET_OP_KNOTS ? q.arg[3].count : 0);
    for (size_t k = counts; k < r->nwant && ok; k++) {
        ok = row_is(r, k, q.arg[3].x[k - counts]);
    }
    et_request_free(&q);
    return ok ? PASS : FAIL;
}

/* ---- what the kinds of a category are, one by one ---- */

static bool drawn(gen *g, et_request *q, et_request_op op, et_category category, uint64_t number)
{
    et_hello h = et_answer_hello(1);
    h.rational = category == ET_CATEGORY_WEIGHTS;
    return gen_check(g, et_campaign_draw(q, op, category, gen_upto(g, 1000), number, &h) == ET_OK, "no case %llu", (unsigned long long)number);
}

static double greatest(const et_request_value *v, size_t width)
{
    double most = 0.0;
    for (size_t i = 0; i < width * v->count; i++) {
        most = fmax(most, fabs(v->x[i]));
    }
    return most;
}

static double smallest(const et_request_value *v, size_t width)
{
    double least = HUGE_VAL;
    for (size_t i = 0; i < width * v->count; i++) {
        least = v->x[i] != 0.0 ? fmin(least, fabs(v->x[i])) : least;
    }
    return least;
}

verdict prop_campaign_draw_extreme_scale(gen *g)
{
    const uint64_t kind = gen_upto(g, 7);
    et_request q;
    if (!drawn(g, &q, ET_OP_CURVE_POINT, ET_CATEGORY_EXTREME_SCALE, kind)) {
        return FAIL;
    }
    const et_request_value *u = &q.arg[1], *P = &q.arg[2];
    const double knots = greatest(u, 1), points = greatest(P, 3), x = q.arg[4].x[0];
    const bool want[8] = {points > 1e305, points < 1e-305, knots > 1e157 && knots < 1e163, knots < 1e-157 && knots > 1e-162, smallest(P, 3) > 9e8,
                          smallest(u, 1) > 9e8, knots < 1e-285, points > 1e150 && knots < 1e-88};
    bool ok = gen_check(g, want[kind], "kind %llu: knots to %g, coordinates to %g", (unsigned long long)kind, knots, points);
    ok = ok && gen_check(g, x >= u->x[0] && x <= u->x[u->count - 1], "the parameter is outside");
    et_request_free(&q);
    return ok ? PASS : FAIL;
}

verdict prop_campaign_draw_degenerate(gen *g)
{
    const uint64_t kind = gen_upto(g, 7);
    et_request q;
    if (!drawn(g, &q, ET_OP_CURVE_POINT, ET_CATEGORY_DEGENERATE, kind)) {
        return FAIL;
    }
    const double *P = q.arg[2].x;
    const size_t n = q.arg[2].count;
    bool equal = true, zero = true, line = true, turns = true;
    for (size_t i = 0; i < n; i++) {
        equal = equal && memcmp(P + 3 * i, P, 3 * sizeof *P) == 0;
        zero = zero && P[3 * i] == 0.0 && P[3 * i + 1] == 0.0 && P[3 * i + 2] == 0.0;
        line = line && P[3 * i + 1] == P[3 * i] && P[3 * i + 2] == 2.0 * P[3 * i];
        turns = turns && memcmp(P + 3 * i, P + 3 * (i % 2), 3 * sizeof *P) == 0;
    }
    const bool pole = n < 2 || memcmp(P, P + 3, 3 * sizeof *P) == 0;
    const bool want[8] = {pole, equal, pole, true, line, turns, pole, zero};
    et_request_free(&q);
    return gen_check(g, want[kind], "kind %llu is not degenerate so", (unsigned long long)kind) ? PASS : FAIL;
}

verdict prop_campaign_draw_seam(gen *g)
{
    const uint64_t kind = 3 * gen_upto(g, 99);
    et_request q;
    if (!drawn(g, &q, ET_OP_CURVE_POINT, ET_CATEGORY_SEAM, kind)) {
        return FAIL;
    }
    bool ok = gen_check(g, memcmp(q.arg[2].x, q.arg[2].x + 3 * (q.arg[2].count - 1), 3 * sizeof(double)) == 0, "the curve is open");
    et_request_free(&q);
    if (!ok || !drawn(g, &q, ET_OP_SEAM_GAP, ET_CATEGORY_SEAM, kind)) {
        return FAIL;
    }
    const size_t nx = q.arg[2].count - q.arg[0].count - 1, ny = q.arg[3].count - q.arg[1].count - 1;
    for (size_t i = 0; i < nx * ny && ok; i++) {
        const bool inside = i / ny > 0 && i / ny + 1 < nx && i % ny > 0 && i % ny + 1 < ny;
        ok = gen_check(g, inside || memcmp(q.arg[4].x + 3 * i, q.arg[10].x + 3 * i, 3 * sizeof(double)) == 0, "border point %zu differs", i);
    }
    et_request_free(&q);
    return ok ? PASS : FAIL;
}

/* What was inserted can be removed: the exact answer is as often as was asked. */
verdict prop_campaign_draw_editing(gen *g)
{
    const et_request_op op = gen_upto(g, 1) ? ET_OP_SURFACE_REMOVE : ET_OP_CURVE_REMOVE;
    et_request q;
    et_truth truth;
    if (!drawn(g, &q, op, ET_CATEGORY_EDITING, 5 * gen_upto(g, 200))) {
        return FAIL;
    }
    bool ok = gen_check(g, et_judge_truth(&truth, &q) == ET_OK && truth.validity == ET_VALID, "no answer");
    if (ok) {
        const double r = (double)q.arg[op == ET_OP_CURVE_REMOVE ? 5 : 8].count;
        ok = gen_check(g, r >= 1.0 && truth.want[0] == r, "%g of %g can be removed", truth.want[0], r);
        et_judge_free(&truth);
    }
    et_request_free(&q);
    return ok ? PASS : FAIL;
}

verdict prop_campaign_draw_fit_failure(gen *g)
{
    static const bool fails_so[8] = {true, true, true, false, false, true, false, true};
    const uint64_t kind = gen_upto(g, 7);
    char reason[128];
    et_request q;
    if (!drawn(g, &q, ET_OP_FIT_CURVE, ET_CATEGORY_FIT_FAILURE, kind)) {
        return FAIL;
    }
    const bool invalid = et_judge_validity(reason, &q) == ET_INVALID;
    et_request_free(&q);
    return gen_check(g, invalid == fails_so[kind], "kind %llu: %s", (unsigned long long)kind, reason) ? PASS : FAIL;
}

/* Among eight cases: two knots, or a knot and the parameter, a few ulps apart; always, in their turn, -0 beside 0. */
verdict prop_campaign_draw_near_knots(gen *g)
{
    size_t close = 0, minus = 0, beside = 0;
    for (uint64_t k = 0; k < 8; k++) {
        et_request q;
        if (!drawn(g, &q, ET_OP_CURVE_POINT, ET_CATEGORY_NEAR_KNOTS, k)) {
            return FAIL;
        }
        const et_request_value *u = &q.arg[1];
        const double size = 0x1p-45 * (u->x[u->count - 1] - u->x[0]), x = q.arg[4].x[0];
        bool near = false, zero = false, by = false;
        for (size_t i = 1; i < u->count; i++) {
            near = near || (u->x[i] > u->x[i - 1] && u->x[i] - u->x[i - 1] < size);
            zero = zero || (u->x[i] == 0.0 && u->x[i - 1] == 0.0 && signbit(u->x[i - 1]) && !signbit(u->x[i]));
            by = by || (x != u->x[i] && fabs(x - u->x[i]) < size);
        }
        close += near;
        minus += zero && k % 4 == 1;
        beside += by || x == 0.0;
        et_request_free(&q);
    }
    const bool ok = close >= 3 && minus == 2 && beside >= 1;
    return gen_check(g, ok, "%zu with close knots, %zu with -0, %zu beside a knot", close, minus, beside) ? PASS : FAIL;
}

verdict prop_campaign_draw_size(gen *g)
{
    static const et_request_op ops[4] = {ET_OP_SPAN, ET_OP_CURVE_POINT, ET_OP_SURFACE_POINT, ET_OP_NET_COUNTS};
    const size_t k = (size_t)gen_upto(g, 3);
    et_request q;
    if (!drawn(g, &q, ops[k], ET_CATEGORY_SIZE, gen_upto(g, 50))) {
        return FAIL;
    }
    const bool want[4] = {q.arg[1].count > 300, q.arg[2].count > 250, q.arg[4].count >= 25, true};
    et_request_free(&q);
    return gen_check(g, want[k], "small for its size") ? PASS : FAIL;
}

/* ---- shrinking ---- */

typedef enum {
    REPEATED, DECREASING, HEAVY, THIRD_POINT, RIGHT_END, LARGE, UNEQUAL, TWO_ROWS, MIXED, SHORT, ANYTHING, SHELL, FRACTION, SEVEN, NEGATIVE, PREDICATES
} predicate;
typedef struct { predicate what; size_t calls; } planted;

static bool valid(const et_request *q)
{
    char reason[128];
    return et_judge_validity(reason, q) == ET_VALID;
}

static size_t repeated_inside(const et_request *q)
{
    const size_t p = q->arg[0].count, nu = q->arg[1].count;
    size_t n = 0;
    for (size_t i = p + 1; i + p + 2 < nu; i++) {
        n += q->arg[1].x[i] == q->arg[1].x[i + 1] && q->arg[1].x[i] > q->arg[1].x[p] && q->arg[1].x[i] < q->arg[1].x[nu - 1 - p];
    }
    return n;
}

static int fails(void *context, const et_request *q)
{
    planted *c = context;
    bool yes = false;
    c->calls++;
    switch (c->what) {
    case REPEATED: return valid(q) && q->arg[0].count >= 3 && repeated_inside(q) > 0;
    case DECREASING:
        for (size_t i = 1; i < q->arg[1].count; i++) {
            yes = yes || q->arg[1].x[i] < q->arg[1].x[i - 1];
        }
        return yes;
    case HEAVY:
        for (size_t i = 0; i < q->arg[3].count; i++) {
            yes = yes || q->arg[3].x[i] > 0.0;
        }
        return valid(q) && yes;
    case THIRD_POINT: return valid(q) && q->arg[1].count >= 3;
    case RIGHT_END: return valid(q) && q->arg[4].x[0] == q->arg[1].x[q->arg[1].count - 1 - q->arg[0].count];
    case LARGE:
        for (size_t i = 0; i < 3 * q->arg[2].count; i++) {
            yes = yes || fabs(q->arg[2].x[i]) > 3.5;
        }
        return valid(q) && yes;
    case UNEQUAL: return valid(q) && q->arg[0].count > q->arg[1].count;
    case TWO_ROWS: return valid(q) && q->arg[5].count >= 2 && q->arg[6].count >= 3;
    case MIXED: return valid(q) && q->arg[10].count >= 2 && q->arg[0].count >= 1 && q->arg[1].count >= 1;
    case SHORT: return q->arg[2].count != q->arg[1].count - q->arg[0].count - 1 && q->arg[2].count > 0 && q->arg[1].count > q->arg[0].count;
    case SHELL: return valid(q);
    case FRACTION: case NEGATIVE:
        for (size_t i = 0; i < 3 * q->arg[2].count; i++) {
            const double x = q->arg[2].x[i];
            yes = yes || (c->what == FRACTION ? x != floor(x) : x < -5.0);
        }
        return yes;
    case SEVEN: return q->arg[0].count >= 7 && q->arg[1].count >= 2;
    default: return 1;
    }
}

/* The simplest there is.  In knots that are clamped, first and last, whole numbers come from 0 on. */
static const struct { et_request_op op; const char *least; } least[PREDICATES] = {
    {ET_OP_CURVE_POINT, "curve_point 3 10 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x1p+0 0x1p+1 0x1p+1 0x1p+1 0x1p+1 6 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 "
                        "0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0 0x0p+0 any"},
    {ET_OP_CURVE_POINT, "curve_point 0 2 0x1p+0 0x0p+0 0 0 0x0p+0 any"},
    {ET_OP_CURVE_POINT, "curve_point 0 2 0x0p+0 0x1p+0 1 0x0p+0 0x0p+0 0x0p+0 1 0x1p+0 0x0p+0 any"},
    {ET_OP_PARAMETERS, "parameters uniform 3 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0"},
    {ET_OP_CURVE_POINT, "curve_point 0 2 0x0p+0 0x1p+0 1 0x0p+0 0x0p+0 0x0p+0 0 0x1p+0 any"},
    {ET_OP_CURVE_POINT, NULL},
    {ET_OP_SURFACE_POINT, "surface_point 1 0 4 0x0p+0 0x0p+0 0x1p+0 0x1p+0 2 0x0p+0 0x1p+0 2 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0 "
                          "0x0p+0 0x0p+0 any any"},
    {ET_OP_FIT_GRID, NULL},
    {ET_OP_SURFACE_DERS, "surface_ders 1 1 4 0x0p+0 0x0p+0 0x1p+0 0x1p+0 4 0x0p+0 0x0p+0 0x1p+0 0x1p+0 4 "
                         "0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0 0x0p+0 0x0p+0 any any 2"},
    {ET_OP_CURVE_POINT, NULL},
    {ET_OP_SEAM_GAP, "seam_gap 0 0 0 0 0 0 0 0 0 0 0 0 0"},
    {ET_OP_SEAM_GAP, "seam_gap 1 1 4 0x0p+0 0x0p+0 0x1p+0 0x1p+0 4 0x0p+0 0x0p+0 0x1p+0 0x1p+0 4 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 "
                     "0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0 1 1 4 0x0p+0 0x0p+0 0x1p+0 0x1p+0 4 0x0p+0 0x0p+0 0x1p+0 0x1p+0 4 0x0p+0 0x0p+0 0x0p+0 "
                     "0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0 0"},
    {ET_OP_CURVE_POINT, NULL}, {ET_OP_NET_COUNTS, "net_counts 7 2"}, {ET_OP_CURVE_POINT, NULL}};

static size_t numbers(const et_request *q)
{
    size_t n = 0;
    for (size_t k = 0; et_request_argument(q->op, k); k++) {
        const et_request_kind kind = et_request_argument(q->op, k)->kind;
        n += kind == ET_ARG_REALS ? q->arg[k].count : kind == ET_ARG_POINTS ? 3 * q->arg[k].count : 0;
    }
    return n;
}

/* One case in 20. */
verdict prop_campaign_shrink(gen *g)
{
    const et_hello h = et_answer_hello(1);
    const predicate what = (predicate)gen_upto(g, PREDICATES - 1);
    const et_category categories[5] = {ET_CATEGORY_PLAIN, ET_CATEGORY_REPEATED_KNOTS, ET_CATEGORY_BAD_INPUT, ET_CATEGORY_WEIGHTS,
                                       ET_CATEGORY_EXTREME_SCALE};
    et_category category = categories[gen_upto(g, 4)];
    const uint64_t seed = gen_upto(g, 1000);
    planted c = {what, 0};
    et_request q, before, again;
    bool found = false;
    category = et_campaign_has(least[what].op, category) ? category : ET_CATEGORY_PLAIN;
    for (uint64_t k = 0; k < 40 && !found; k++) {
        if (et_campaign_draw(&q, least[what].op, category, seed, k, &h) == ET_OK) {
            found = fails(&c, &q);
            if (!found) {
                et_request_free(&q);
            }
        }
    }
    if (!found) {
        return SKIP;
    }
    c.calls = 0;
    bool ok = et_request_copy(&before, &q) == ET_OK;
    ok = ok && gen_check(g, et_campaign_shrink(&q, fails, &c, 0) == ET_OK && c.calls == 0, "calls beyond the limit");
    ok = ok && gen_check(g, same_text(&q, &before), "shrunk without a call");
    const size_t few = (size_t)gen_upto(g, 50);
    ok = ok && gen_check(g, et_campaign_shrink(&q, fails, &c, few) == ET_OK && c.calls <= few, "%zu calls of %zu", c.calls, few);
    ok = ok && gen_check(g, fails(&c, &q), "it fails no more after a few calls");
    ok = ok && gen_check(g, et_campaign_shrink(&q, fails, &c, 20000) == ET_OK && fails(&c, &q), "it fails no more");
    ok = ok && gen_check(g, numbers(&q) <= numbers(&before), "%zu numbers, before %zu", numbers(&q), numbers(&before));
    char *line = text_of(&q);
    gen_note(g, "shrunk: %.700s", line);
    ok = ok && gen_check(g, !least[what].least || strcmp(line, least[what].least) == 0, "not the least, which is %s", least[what].least);
    const double *P = q.arg[2].x;
    ok = ok && gen_check(g, what != LARGE || (numbers(&q) == 5 && fabs(P[0]) + fabs(P[1]) + fabs(P[2]) == 4.0), "not one coordinate of 4");
    const double only = numbers(&q) == 3 ? P[0] + P[1] + P[2] : 0.0;
    ok = ok && gen_check(g, what != FRACTION || fabs(only) == 0.5, "not a half: %a", only);
    ok = ok && gen_check(g, what != NEGATIVE || only == -8.0 || only == -6.0, "not the least below -5: %a", only);
    ok = ok && gen_check(g, what != SHORT || numbers(&q) == 4, "%zu numbers where 4 do", numbers(&q));
    ok = ok && gen_check(g, et_request_copy(&again, &q) == ET_OK && et_campaign_shrink(&again, fails, &c, 20000) == ET_OK, "shrinking again fails");
    ok = ok && gen_check(g, same_text(&q, &again), "shrinking again goes on");
    free(line);
    et_request_free(&again);
    et_request_free(&before);
    et_request_free(&q);
    return ok ? PASS : FAIL;
}

/* ---- relations ---- */

typedef enum { RIGHT, EVERY, OTHER, REFUSE, UNSUPPORT, INFINITE, SHORTER, STOP, WAYS } way;
typedef struct { way how; size_t asked; } asker;

static et_status ask(void *context, et_reply *reply, const et_request *q)
{
    asker *a = context;
    const bool nearest = q->op == ET_OP_CURVE_NEAREST || q->op == ET_OP_SURFACE_NEAREST;
    memset(reply, 0, sizeof *reply);
    if (a->how == STOP) {
        return ET_ESTOPPED;
    }
    const et_status status = nearest ? et_answer_exact(reply, q) : et_answer_fast(reply, q);
    const bool off = a->how == EVERY || (a->how == OTHER && a->asked % 2 == 1);
    a->asked++;
    if (status != ET_OK) {
        return status;
    }
    for (size_t i = 0; off && i < reply->count; i++) {
        reply->x[i] = reply->x[i] * (1.0 + 0x1p-6) + 0x1p-6;
    }
    if ((a->how == REFUSE || a->how == UNSUPPORT || a->how == SHORTER) && reply->kind == ET_REPLY_OK) {
        et_reply_free(reply);
        memset(reply, 0, sizeof *reply);
        reply->kind = a->how == REFUSE ? ET_REPLY_REFUSED : a->how == UNSUPPORT ? ET_REPLY_UNSUPPORTED : ET_REPLY_OK;
    }
    for (size_t i = 0; a->how == INFINITE && i < reply->count; i++) {
        reply->x[i] = i % 2 ? NAN : HUGE_VAL;
    }
    return ET_OK;
}

/* Right answers pass every relation; wrong ones do not, nor refusals, infinities, or missing numbers. */
/* One case in 16. */
verdict prop_campaign_relate(gen *g)
{
    const et_hello h = et_answer_hello(1);
    const size_t relation = (size_t)gen_upto(g, et_campaign_relations() - 1);
    asker a = {(way)gen_upto(g, WAYS - 1), 0};
    const uint64_t seed = gen_upto(g, 1000);
    size_t unsupported = 0, bad = 0;
    bool ok = true;
    for (uint64_t number = 0; ok && number < 6; number++) {
        et_judgement j = {ET_VERDICT_CRASH, 0, 0.0, 0.0, 0.0, 0.0, ""};
        et_request q = {ET_OPS, {{7, NULL}}};
        a.asked = a.how == OTHER ? number : 0;
        const et_status status = et_campaign_relate(&j, &q, relation, seed, number, &h, ask, &a);
        if (a.how == STOP && status != ET_OK) {
            ok = gen_check(g, status == ET_ESTOPPED, "status %d", (int)status);
            ok = ok && gen_check(g, q.op == ET_OPS && j.verdict == ET_VERDICT_CRASH, "something was touched");
            bad++;
            continue;
        }
        ok = gen_check(g, status == ET_OK && (unsigned)j.verdict < ET_VERDICTS, "status %d", (int)status);
        if (ok) {
            const bool is_bad = et_judge_bad(j.verdict) != 0;
            unsupported += j.verdict == ET_VERDICT_UNSUPPORTED;
            bad += is_bad;
            ok = gen_check(g, is_bad == (j.text[0] != 0), "a verdict without a sentence, or the other way round");
            ok = ok && gen_check(g, !is_bad || a.how != RIGHT, "right answers: %s", j.text);
            ok = ok && gen_check(g, a.how != REFUSE || !is_bad || j.verdict == ET_VERDICT_WRONGLY_REFUSED, "refused: %s", j.text);
            ok = ok && gen_check(g, a.how != UNSUPPORT || j.verdict == ET_VERDICT_UNSUPPORTED, "unsupported: %s", j.text);
            et_request_free(&q);
        }
    }
    /* Answers that are wrong in the same way keep most relations; sums of basis functions show them. */
    const bool should = a.how != RIGHT && a.how != UNSUPPORT && (a.how != EVERY || relation == 3 || relation == 4);
    ok = ok && gen_check(g, !should || bad > 0, "%s: wrong answers (%d) pass", et_campaign_relation_name(relation), (int)a.how);
    ok = ok && gen_check(g, a.how != RIGHT || unsupported < 6, "%s: nothing was compared", et_campaign_relation_name(relation));
    gen_note(g, "relation %zu, %s, seed %llu, way %d", relation, et_campaign_relation_name(relation), (unsigned long long)seed, (int)a.how);
    return ok ? PASS : FAIL;
}

/* Nothing offered: unsupported.  No such relation: an error. */
verdict prop_campaign_relate_nothing(gen *g)
{
    et_hello h = et_answer_hello(1);
    const size_t n = et_campaign_relations(), relation = (size_t)gen_upto(g, n);
    asker a = {RIGHT, 0};
    et_judgement j = {ET_VERDICT_CRASH, 0, 0.0, 0.0, 0.0, 0.0, ""};
    et_request q = {ET_OPS, {{7, NULL}}};
    memset(h.op, 0, sizeof h.op);
    const et_status status = et_campaign_relate(&j, &q, relation, gen_upto(g, 9), gen_upto(g, 9), &h, ask, &a);
    if (relation == n) {
        return gen_check(g, status == ET_EINVAL && q.op == ET_OPS && j.verdict == ET_VERDICT_CRASH, "status %d", (int)status) ? PASS : FAIL;
    }
    bool ok = gen_check(g, status == ET_OK && j.verdict == ET_VERDICT_UNSUPPORTED, "status %d, verdict %d", (int)status, (int)j.verdict);
    ok = ok && gen_check(g, a.asked == 0, "asked though nothing is offered");
    if (status == ET_OK) {
        et_request_free(&q);
    }
    return ok ? PASS : FAIL;
}

/* ---- neighbours ---- */

verdict prop_campaign_vary(gen *g)
{
    const et_hello h = draw_hello(g);
    const et_request_op op = (et_request_op)gen_upto(g, ET_OPS - 1);
    const et_category categories[5] = {ET_CATEGORY_PLAIN, ET_CATEGORY_REPEATED_KNOTS, ET_CATEGORY_NEAR_KNOTS, ET_CATEGORY_WEIGHTS,
                                       ET_CATEGORY_DEGENERATE};
    et_category category = categories[gen_upto(g, 4)];
    const uint64_t seed = gen_upto(g, 1000), number = gen_upto(g, 1000);
    char reason[128];
    et_request q, a, b;
    category = et_campaign_has(op, category) ? category : ET_CATEGORY_PLAIN;
    if (et_campaign_draw(&q, op, category, seed, number, &h) != ET_OK) {
        return SKIP;
    }
    bool ok = gen_check(g, et_campaign_vary(&a, &q, seed, number, &h) == ET_OK && et_campaign_vary(&b, &q, seed, number, &h) == ET_OK, "not varied");
    if (!ok) {
        return FAIL;
    }
    ok = gen_check(g, same_text(&a, &b), "varied twice: not the same");
    ok = ok && gen_check(g, et_judge_validity(reason, &a) == et_judge_validity(reason, &q), "another validity: %s", reason);
    ok = ok && gen_check(g, a.op == q.op, "another operation") && keeps_to(g, &a, &h);
    for (size_t k = 0; ok && et_request_argument(op, k); k++) {
        ok = gen_check(g, a.arg[k].count == q.arg[k].count, "argument %zu has another length", k);
    }
    gen_label(g, same_text(&a, &q) ? "the same" : "moved");
    et_request_free(&a);
    et_request_free(&b);
    et_request_free(&q);
    return ok ? PASS : FAIL;
}

/* Among some neighbours, most are different, and parameters, knots, points and weights have all moved. */
/* One case in 20. */
verdict prop_campaign_vary_all(gen *g)
{
    const et_hello h = et_answer_hello(1);
    const uint64_t seed = gen_upto(g, 1000);
    size_t moved[5] = {0, 0, 0, 0, 0};
    et_request q, a;
    if (et_campaign_draw(&q, ET_OP_CURVE_POINT, ET_CATEGORY_WEIGHTS, seed, 3, &h) != ET_OK) {
        return FAIL;
    }
    for (uint64_t k = 0; k < 60; k++) {
        if (et_campaign_vary(&a, &q, seed, k, &h) != ET_OK) {
            et_request_free(&q);
            return FAIL;
        }
        for (size_t i = 1; i < 5; i++) {
            const size_t n = (i == 2 ? 3 : 1) * (i == 4 ? 1 : q.arg[i].count);
            moved[i] += memcmp(a.arg[i].x, q.arg[i].x, n * sizeof(double)) != 0;
        }
        moved[0] += !same_text(&a, &q);
        et_request_free(&a);
    }
    et_request_free(&q);
    const bool ok = gen_check(g, moved[0] > 45, "only %zu of 60 are different", moved[0]);
    const bool all = moved[1] > 2 && moved[2] > 2 && moved[3] > 2 && moved[4] > 2;
    return ok && gen_check(g, all, "moved: knots %zu, points %zu, weights %zu, x %zu of 60", moved[1], moved[2], moved[3], moved[4]) ? PASS : FAIL;
}
