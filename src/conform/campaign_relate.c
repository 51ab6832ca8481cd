/* campaign, relations: what they have in common, and the list of them. */
#include "conform/campaign_relate.h"
#include "etalon/base/size.h"
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

void campaign_fail(campaign_relation *r, et_status status)
{
    r->status = r->status == ET_OK ? status : r->status;
}

void campaign_decide(campaign_relation *r, et_verdict verdict, const char *text)
{
    r->decided = 1;
    r->judgement->verdict = verdict;
    r->judgement->at = SIZE_MAX;
    if (et_judge_bad(verdict)) {
        snprintf(r->judgement->text, sizeof r->judgement->text, "%s: %s", r->name, text);
    }
}

int campaign_base(campaign_relation *r, et_request_op op, const et_category *categories, size_t n)
{
    enum { TRIES = 32 };
    char reason[128];
    for (uint64_t k = 0; k < TRIES && r->status == ET_OK; k++) {
        et_request q;
        const et_category category = categories[(size_t)((r->number + k / 4) % n)];
        const et_status status = et_campaign_draw(&q, op, category, et_rng_stream(r->seed, r->number), k, r->hello);
        if (status == ET_OK && et_judge_validity(reason, &q) == ET_VALID) {
            et_request_free(r->told);
            *r->told = q;
            return 1;
        }
        if (status == ET_OK) {
            et_request_free(&q);
        } else if (status != ET_EINVAL) {
            campaign_fail(r, status);
        }
    }
    campaign_decide(r, ET_VERDICT_UNSUPPORTED, "");
    return 0;
}

int campaign_again(campaign_relation *r, et_request *q)
{
    campaign_fail(r, et_request_copy(q, r->told));
    return r->status == ET_OK;
}

int campaign_asked(campaign_relation *r, et_reply *reply, const et_request *q, size_t count)
{
    char reason[128];
    if (r->status != ET_OK || r->decided) {
        return 0;
    }
    /* What is drawn is valid; what is made of it by an operation may have left what is asked of answers. */
    if (!campaign_offered(q, r->hello) || et_judge_validity(reason, q) != ET_VALID) {
        campaign_decide(r, ET_VERDICT_UNSUPPORTED, "");
        return 0;
    }
    const et_status status = r->ask(r->context, reply, q);
    if (status != ET_OK) {
        campaign_fail(r, status);
        return 0;
    }
    int finite = 1;
    for (size_t i = 0; i < reply->count; i++) {
        finite = finite && isfinite(reply->x[i]);
    }
    if (reply->kind == ET_REPLY_UNSUPPORTED) {
        campaign_decide(r, ET_VERDICT_UNSUPPORTED, "");
    } else if (reply->kind == ET_REPLY_REFUSED) {
        campaign_decide(r, ET_VERDICT_WRONGLY_REFUSED, "a valid request was refused");
    } else if (count != SIZE_MAX && reply->count != count) {
        campaign_decide(r, ET_VERDICT_WRONG, "not as many numbers as there should be");
    } else if (!finite) {
        campaign_decide(r, ET_VERDICT_NON_FINITE, "a number is not finite");
    } else {
        return 1;
    }
    et_reply_free(reply);
    return 0;
}

double *campaign_bounds(campaign_relation *r, size_t *n, const et_request *q)
{
    et_truth truth;
    if (r->status != ET_OK || r->decided) {
        return NULL;
    }
    const et_status status = et_judge_truth(&truth, q);
    if (status != ET_OK) {
        if (status == ET_ENOCONV) {
            campaign_decide(r, ET_VERDICT_UNSUPPORTED, "");
        } else {
            campaign_fail(r, status);
        }
        return NULL;
    }
    double *bound = et_size_array(truth.count, sizeof *bound);
    *n = truth.count;
    for (size_t i = 0; bound && i < truth.count; i++) {
        bound[i] = truth.bound[i];
        if (truth.other) {
            bound[i] += fabs(truth.want[i] - truth.other[i]) + truth.other_bound[i];
        }
    }
    const int right = truth.validity == ET_VALID;          /* then something is wanted */
    et_judge_free(&truth);
    if (!bound) {
        campaign_fail(r, ET_ENOMEM);
    } else if (!right) {
        campaign_decide(r, ET_VERDICT_UNSUPPORTED, "");
        free(bound);
        bound = NULL;
    }
    return bound;
}

void campaign_compare(campaign_relation *r, size_t at, double got, double want, double tolerance)
{
    const double error = fabs(got - want), ratio = error == 0.0 ? 0.0 : error / tolerance;
    r->exact = r->exact && got == want;
    if (!(ratio <= r->worst)) {
        r->worst = ratio;
        r->judgement->at = at;
        r->judgement->got = got;
        r->judgement->want = want;
        r->judgement->bound = tolerance;
        r->judgement->ratio = ratio;
    }
}

double campaign_size(const et_request *q, int points)
{
    double size = 0x1p-1000;
    for (size_t i = 0; i < 3 * q->arg[points].count; i++) {
        size = fmax(size, fabs(q->arg[points].x[i]));
    }
    return size;
}

void campaign_dyadic(et_request_value *v)
{
    for (size_t i = 0; i < 3 * v->count; i++) {
        v->x[i] = ldexp(floor(ldexp(v->x[i], 20)), -20);
    }
}

void campaign_reverse(double *x, size_t n, size_t width)
{
    for (size_t i = 0; i < n / 2; i++) {
        for (size_t c = 0; c < width; c++) {
            const double t = x[i * width + c];
            x[i * width + c] = x[(n - 1 - i) * width + c];
            x[(n - 1 - i) * width + c] = t;
        }
    }
}

void campaign_negate(et_request_value *u)
{
    campaign_reverse(u->x, u->count, 1);
    for (size_t i = 0; i < u->count; i++) {
        u->x[i] = 0.0 - u->x[i];
    }
}

/* ---- the list ---- */

static const char *const names[] = {
    "curve_point = curve_ders of order 0", "surface_point = surface_ders of order 0", "basis = basis_ders of order 0",
    "basis functions add up to 1", "derivatives of basis functions add up to 0",
    "curve_ders: translation", "curve_ders: scaling by a power of two", "curve_ders: reversal",
    "surface_ders: translation", "surface_ders: scaling by a power of two", "surface_ders: reversal", "surface_ders: transposition",
    "left limit = right limit where continuous", "span fits multiplicity", "Greville points reproduce the parameter",
    "curve_insert keeps the curve", "curve_elevate keeps the curve", "curve_insert, then curve_remove",
    "surface_insert keeps the surface", "surface_elevate keeps the surface",
    "parameters: translation", "parameters: scaling by a power of two", "parameters: reversal",
    "fit_curve: translation", "fit_curve: scaling by a power of two", "fit_curve: reversal", "fit_curve: normal equations",
    "fit_grid: translation", "fit_grid: scaling by a power of two", "fit_grid: reversal", "fit_grid: normal equations",
    "fit_scattered: translation", "fit_scattered: scaling by a power of two", "fit_scattered: reversal", "fit_scattered: normal equations",
    "approximate: translation", "approximate: scaling by a power of two", "approximate: reversal",
    "seam_gap of an equal border is 0", "curve_nearest of a point of the curve", "surface_nearest of a point of the surface",
    "net_node inverts net_class", NULL};

size_t et_campaign_relations(void)
{
    return sizeof names / sizeof names[0] - 1;
}

const char *et_campaign_relation_name(size_t relation)
{
    return relation < et_campaign_relations() ? names[relation] : NULL;
}

static void fitted(campaign_relation *r, et_request_op op, size_t how)
{
    if (how < 3) {
        campaign_relate_fitted(r, op, (int)how);
    } else {
        campaign_relate_normal(r, op);
    }
}

static void relate(campaign_relation *r, size_t k)
{
    switch (k) {
    case 0: campaign_relate_order(r, ET_OP_CURVE_DERS, ET_OP_CURVE_POINT); break;
    case 1: campaign_relate_order(r, ET_OP_SURFACE_DERS, ET_OP_SURFACE_POINT); break;
    case 2: campaign_relate_order(r, ET_OP_BASIS_DERS, ET_OP_BASIS); break;
    case 3: campaign_relate_unity(r); break;
    case 4: campaign_relate_constant(r); break;
    case 5: case 6: case 7: campaign_relate_moved(r, ET_OP_CURVE_DERS, (int)k - 5); break;
    case 8: case 9: case 10: campaign_relate_moved(r, ET_OP_SURFACE_DERS, (int)k - 8); break;
    case 11: campaign_relate_transposed(r); break;
    case 12: campaign_relate_limits(r); break;
    case 13: campaign_relate_spans(r); break;
    case 14: campaign_relate_greville(r); break;
    case 15: campaign_relate_edited(r, ET_OP_CURVE_INSERT); break;
    case 16: campaign_relate_edited(r, ET_OP_CURVE_ELEVATE); break;
    case 17: campaign_relate_removed(r); break;
    case 18: campaign_relate_edited(r, ET_OP_SURFACE_INSERT); break;
    case 19: campaign_relate_edited(r, ET_OP_SURFACE_ELEVATE); break;
    case 20: case 21: case 22: campaign_relate_parameters(r, (int)k - 20); break;
    case 23: case 24: case 25: case 26: fitted(r, ET_OP_FIT_CURVE, k - 23); break;
    case 27: case 28: case 29: case 30: fitted(r, ET_OP_FIT_GRID, k - 27); break;
    case 31: case 32: case 33: case 34: fitted(r, ET_OP_FIT_SCATTERED, k - 31); break;
    case 35: case 36: case 37: campaign_relate_approximate(r, (int)k - 35); break;
    case 38: campaign_relate_seam(r); break;
    case 39: campaign_relate_nearest(r, ET_OP_CURVE_NEAREST); break;
    case 40: campaign_relate_nearest(r, ET_OP_SURFACE_NEAREST); break;
    default: campaign_relate_net(r); break;
    }
}

/* The verdict of the comparisons: factors as for single answers (docs/conformance.md). */
static void conclude(campaign_relation *r)
{
    et_judgement *j = r->judgement;
    if (r->decided) {
        return;
    }
    j->verdict = r->worst < 0.0        ? ET_VERDICT_UNSUPPORTED
                 : r->exact            ? ET_VERDICT_CORRECTLY_ROUNDED
                 : r->worst <= 1.0     ? ET_VERDICT_WITHIN_BOUND
                 : r->worst <= 0x1p20  ? ET_VERDICT_INACCURATE
                                       : ET_VERDICT_WRONG;
    if (et_judge_bad(j->verdict)) {
        snprintf(j->text, sizeof j->text, "%s: number %zu is %.17g against %.17g, %.3g times what errors allow", r->name, j->at, j->got, j->want,
            j->ratio);
    }
}

et_status et_campaign_relate(et_judgement *judgement, et_request *request, size_t relation, uint64_t seed, uint64_t number, const et_hello *hello,
                             et_campaign_ask *ask, void *context)
{
    et_rng *rng;
    et_request told;
    et_judgement j = {ET_VERDICT_UNSUPPORTED, SIZE_MAX, 0.0, 0.0, 0.0, 0.0, ""};
    if (relation >= et_campaign_relations()) {
        return ET_EINVAL;
    }
    const uint64_t own = et_rng_stream(seed, relation);
    et_status status = et_rng_new(&rng, et_rng_stream(own, number));
    if (status != ET_OK) {
        return status;
    }
    status = et_request_new(&told, ET_OP_SPAN);
    if (status == ET_OK) {
        campaign_relation r = {names[relation], &j, &told, hello, ask, context, rng, own, number, -1.0, 1, 0, ET_OK};
        relate(&r, relation);
        conclude(&r);
        status = r.status;
        if (status == ET_OK) {
            *judgement = j;
            *request = told;
        } else {
            et_request_free(&told);
        }
    }
    et_rng_free(rng);
    return status;
}
