/* frozen FILE...: the frozen vectors against the exact layer, which shares nothing with the program that made them: the same validity, the same
 * wanted numbers bit for bit (zeros of either sign are one; limits from the left as well), bounds that agree to 1e-9 (and 2^-1064: among subnormals
 * nothing agrees to 1e-9).  Of nearest points the parameters are free, and the exact layer's distance is above that of the vector, which is the least, by its
 * bound at most.  And each vector against the judge: what is wanted is right, the limit from the left, too; what is off by more than its bound is
 * not; refusals as the validity says. */
#include "etalon/conform/vectors.h"
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static size_t passed, failed;

typedef struct { const et_vector *vector; const char *path; size_t faults; } view;

static bool say(view *v, bool ok, const char *what, size_t at, double got, double want)
{
    if (!ok && v->faults++ < 5)
        printf("  %s: %s %zu: %a, vector %a\n", v->vector->id, what, at, got, want);
    return ok;
}

static bool is_nearest(const view *v)
{
    return v->vector->request.op == ET_OP_CURVE_NEAREST || v->vector->request.op == ET_OP_SURFACE_NEAREST;
}

static bool same_number(const view *v, size_t at, double got, double want)
{
    if (!is_nearest(v))
        return got == want;
    return at + 1 < v->vector->truth.count || (got >= want && got - want <= v->vector->truth.bound[at]);
}

static bool same_bound(double got, double want)
{
    return got == want || fabs(got - want) <= 1e-9 * want + 0x1p-1064;
}

static bool same_numbers(view *v, const char *what, const double *got, const double *got_bound, const double *want, const double *bound, size_t n)
{
    for (size_t k = 0; k < n; k++)
        if (!say(v, same_number(v, k, got[k], want[k]), what, k, got[k], want[k]) || !say(v, same_bound(got_bound[k], bound[k]), "bound", k,
                                                                                          got_bound[k], bound[k]))
            return false;
    return true;
}

static void against_truth(view *v)
{
    const et_truth *t = &v->vector->truth;
    et_truth got;

    if (!say(v, et_judge_truth(&got, &v->vector->request) == ET_OK, "no truth", 0, 0, 0))
        return;
    if (say(v, got.validity == t->validity, "validity", 0, (double)got.validity, (double)t->validity)
        && say(v, got.count == t->count, "numbers", 0, (double)got.count, (double)t->count)
        && say(v, (got.other == NULL) == (t->other == NULL), "limits from the left", 0, got.other != NULL, t->other != NULL)
        && same_numbers(v, "number", got.want, got.bound, t->want, t->bound, t->count) && t->other)
        same_numbers(v, "number from the left", got.other, got.other_bound, t->other, t->other_bound, t->count);
    et_judge_free(&got);
}

static et_verdict judged(const view *v, et_reply_kind kind, const double *x, size_t n)
{
    et_reply reply = { .kind = kind };
    et_judgement judgement = { .verdict = ET_VERDICTS };

    if (et_reply_put(&reply, x, n) == ET_OK)
        (void)et_judge_reply(&judgement, &v->vector->request, &v->vector->truth, &reply);
    et_reply_free(&reply);
    return judgement.verdict;
}

static void refusals(view *v)
{
    static const et_verdict right[] = { ET_VERDICT_WRONGLY_REFUSED, ET_VERDICT_WITHIN_BOUND, ET_VERDICT_CORRECTLY_ROUNDED };
    const et_truth *t = &v->vector->truth;
    const et_verdict got = judged(v, ET_REPLY_REFUSED, NULL, 0);

    say(v, got == right[t->validity], "a refusal's verdict", 0, (double)got, (double)right[t->validity]);
    if (t->validity == ET_INVALID)
        say(v, judged(v, ET_REPLY_OK, (const double[]){ 1 }, 1) == ET_VERDICT_WRONGLY_ACCEPTED, "an answer is accepted", 0, 0, 0);
}

/* Each number in turn is put beyond its bound, if it has one that leaves room. */
static void altered(view *v)
{
    const et_truth *t = &v->vector->truth;
    double *x = malloc((t->count ? t->count : 1) * sizeof *x);

    for (size_t k = 0; x && k < t->count; k += 1 + t->count / 8) {
        const double by = fmax(3 * t->bound[k], fabs(t->want[k]) * 0x1p-50) + 0x1p-1060;
        memcpy(x, t->want, t->count * sizeof *x);
        x[k] += by;
        if (isfinite(by) && isfinite(x[k]) && !t->other)
            say(v, et_judge_bad(judged(v, ET_REPLY_OK, x, t->count)), "altered, and taken for right, number", k, x[k], t->want[k]);
    }
    free(x);
}

/* A curve or a surface whose knots are removed may be right in more than one way; a point's parameter may be another. */
static bool has_one_answer(const view *v)
{
    const et_request_op op = v->vector->request.op;

    return op != ET_OP_CURVE_REMOVE && op != ET_OP_SURFACE_REMOVE && !is_nearest(v);
}

static bool all_finite(const double *x, size_t n)
{
    for (size_t k = 0; k < n; k++)
        if (!isfinite(x[k]))
            return false;
    return true;
}

static void against_judge(view *v)
{
    const et_truth *t = &v->vector->truth;
    et_verdict got;

    refusals(v);
    if (t->count == 0 || !all_finite(t->want, t->count))
        return;
    got = judged(v, ET_REPLY_OK, t->want, t->count);
    say(v, got == ET_VERDICT_CORRECTLY_ROUNDED || (got == ET_VERDICT_WITHIN_BOUND && is_nearest(v)), "what is wanted has the verdict", 0,
        (double)got, 0);
    if (t->other && all_finite(t->other, t->count))
        say(v, judged(v, ET_REPLY_OK, t->other, t->count) == ET_VERDICT_CORRECTLY_ROUNDED, "the limit from the left is not right", 0, 0, 0);
    if (has_one_answer(v) && t->validity == ET_VALID)
        altered(v);
}

static void read_file(const char *path)
{
    et_vectors all;
    et_message message;
    size_t wrong = 0;

    if (et_vectors_read(&all, path, &message) != ET_OK) {
        printf("FAIL %s\n", message.text);
        failed++;
        return;
    }
    for (size_t k = 0; k < all.count; k++) {
        view v = { &all.vector[k], path, 0 };
        against_truth(&v);
        against_judge(&v);
        wrong += v.faults > 0;
    }
    printf("%s %s: %zu vectors%s", wrong ? "FAIL" : "ok", path, all.count, wrong ? "" : "\n");
    if (wrong)
        printf(", %zu of which the exact layer or the judge sees otherwise\n", wrong);
    passed += wrong == 0;
    failed += wrong > 0;
    et_vectors_free(&all);
}

int main(int argc, char **argv)
{
    for (int k = 1; k < argc; k++)
        read_file(argv[k]);
    printf("%zu passed, %zu failed\n", passed, failed);
    return failed > 0 || argc < 2;
}
