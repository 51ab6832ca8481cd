/* judge_reply: the verdict of a reply. */
#include "conform/judge_parts.h"
#include "etalon/base/size.h"
#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void judge_say(et_judgement *judgement, et_verdict verdict, const char *format, ...)
{
    va_list arguments;

    judgement->verdict = verdict;
    va_start(arguments, format);
    vsnprintf(judgement->text, sizeof judgement->text, format, arguments);
    va_end(arguments);
}

static et_judgement begin(et_verdict verdict)
{
    et_judgement j;

    memset(&j, 0, sizeof j);
    j.verdict = verdict;
    j.at = SIZE_MAX;
    return j;
}

/* ---- numbers ---- */

/* error / bound: infinite where nothing may be off. */
static double ratio_of(double got, double want, double bound)
{
    const double error = fabs(got - want);

    if (got == want || isinf(bound))
        return 0;
    return isinf(error) ? fabs(got / 2 - want / 2) / bound * 2 : error / bound;
}

static void tell(et_judgement *j, const et_request *request, const double *want)
{
    char name[96];

    judge_name(name, request, want, j->at);
    if (j->verdict == ET_VERDICT_NON_FINITE)
        judge_say(j, j->verdict, "%s is %a, should be %a (%.6g)", name, j->got, j->want, j->want);
    else if (j->bound == 0)
        judge_say(j, j->verdict, "%s is %.17g, should be %.17g", name, j->got, j->want);
    else
        judge_say(j, j->verdict, "%s is %a, should be %a (%.17g instead of %.17g): %.3g bounds off", name, j->got, j->want, j->got, j->want,
                  j->ratio);
}

void judge_compare(et_judgement *judgement, const et_request *request, const double *got, const double *want, const double *bound, size_t n)
{
    et_judgement j = begin(ET_VERDICT_CORRECTLY_ROUNDED);
    int equal = 1, finite = 1;

    for (size_t i = 0; i < n && finite; i++) {
        const double ratio = isfinite(got[i]) ? ratio_of(got[i], want[i], bound[i]) : 0;
        equal = equal && got[i] == want[i];
        finite = isfinite(got[i]) || isinf(bound[i]);
        if (!finite || ratio > j.ratio || (j.at == SIZE_MAX && got[i] != want[i])) {
            j.at = i;
            j.got = got[i];
            j.want = want[i];
            j.bound = bound[i];
            j.ratio = ratio;
        }
    }
    j.verdict = !finite          ? ET_VERDICT_NON_FINITE
              : equal            ? ET_VERDICT_CORRECTLY_ROUNDED
              : j.ratio <= 1     ? ET_VERDICT_WITHIN_BOUND
              : j.ratio <= 0x1p20 ? ET_VERDICT_INACCURATE
                                  : ET_VERDICT_WRONG;
    if (et_judge_bad(j.verdict))
        tell(&j, request, want);
    *judgement = j;
}

/* ---- one-sided limits ---- */

static void better(et_judgement *judgement, const et_judgement *other)
{
    /* verdicts are in the order of what is worse, up to non-finite */
    if (other->verdict < judgement->verdict || (other->verdict == judgement->verdict && other->ratio < judgement->ratio))
        *judgement = *other;
}

/* From the right in one direction and from the left in the other; where there is no normal, any answer will do. */
static et_status mixed(et_judgement *judgement, const et_request *request, const et_reply *reply)
{
    et_status status = ET_OK;

    for (int k = 0; status == ET_OK && k < 2 && judgement->verdict != ET_VERDICT_CORRECTLY_ROUNDED; k++) {
        judge_list list;
        int left[2];
        judge_sides(left, request, k, !k);
        status = judge_limits(&list, request, left[0], left[1]);
        if (status == ET_OK) {
            et_judgement j = begin(ET_VERDICT_WITHIN_BOUND);
            if (list.count == reply->count)
                judge_compare(&j, request, reply->x, list.want, list.bound, list.count);
            better(judgement, &j);
            judge_list_free(&list);
        }
    }
    return status == ET_ENOMEM ? status : ET_OK;
}

static et_status numbers(et_judgement *judgement, const et_request *request, const et_truth *truth, const et_reply *reply)
{
    et_judgement j;
    int left[2];

    if (reply->count != truth->count) {
        judge_say(judgement, ET_VERDICT_WRONG, "%zu numbers instead of %zu", reply->count, truth->count);
        judgement->ratio = INFINITY;
        return ET_OK;
    }
    judge_compare(judgement, request, reply->x, truth->want, truth->bound, truth->count);
    if (truth->other && judgement->verdict != ET_VERDICT_CORRECTLY_ROUNDED) {
        judge_compare(&j, request, reply->x, truth->other, truth->other_bound, truth->count);
        better(judgement, &j);
    }
    if (truth->other && et_judge_bad(judgement->verdict) && judge_sides(left, request, 0, 0) == 3)
        return mixed(judgement, request, reply);
    return ET_OK;
}

/* ---- all ---- */

/* Whether the numbers of a truth, which may have been read from anywhere, can be those of this request: what follows relies on its knots and its
 * counts. */
static int can_be(const et_request *request, const et_truth *truth)
{
    const size_t n = request->op == ET_OP_CURVE_NEAREST ? 2 : request->op == ET_OP_SURFACE_NEAREST ? 3 : truth->count;
    judge_case c;

    judge_valid(&c, request);
    return c.validity != ET_INVALID && truth->count == n;
}

static et_status answered(et_judgement *j, const et_request *request, const et_truth *truth, const et_reply *reply)
{
    if (truth->validity == ET_INVALID) {
        judge_say(j, ET_VERDICT_WRONGLY_ACCEPTED, "answered, though %s", truth->reason[0] ? truth->reason : "the request is invalid");
        return ET_OK;
    }
    if (request->op == ET_OP_APPROXIMATE && truth->validity == ET_VALID)
        return judge_approximate(j, request, reply);
    if (truth->count == 0) {
        j->verdict = ET_VERDICT_WITHIN_BOUND;
        return ET_OK;
    }
    if (!can_be(request, truth))
        return ET_EINVAL;
    switch (request->op) {
    case ET_OP_CURVE_INSERT: case ET_OP_CURVE_ELEVATE: case ET_OP_SURFACE_INSERT: case ET_OP_SURFACE_ELEVATE:
        return judge_edit(j, request, truth, reply);
    case ET_OP_CURVE_REMOVE: case ET_OP_SURFACE_REMOVE:
        return judge_removal(j, request, truth, reply);
    case ET_OP_CURVE_NEAREST: case ET_OP_SURFACE_NEAREST:
        return judge_nearest(j, request, truth, reply);
    default:
        return numbers(j, request, truth, reply);
    }
}

et_status et_judge_reply(et_judgement *judgement, const et_request *request, const et_truth *truth, const et_reply *reply)
{
    et_judgement j = begin(ET_VERDICT_UNSUPPORTED);
    et_status status = ET_OK;

    if (reply->kind == ET_REPLY_REFUSED) {
        if (truth->validity == ET_VALID)
            judge_say(&j, ET_VERDICT_WRONGLY_REFUSED, "refused, though the request is valid%s%.120s", reply->reason[0] ? ": " : "", reply->reason);
        else
            j.verdict = truth->validity == ET_INVALID ? ET_VERDICT_CORRECTLY_ROUNDED : ET_VERDICT_WITHIN_BOUND;
    } else if (reply->kind == ET_REPLY_OK) {
        status = answered(&j, request, truth, reply);
    }
    if (status == ET_OK)
        *judgement = j;
    return status;
}
