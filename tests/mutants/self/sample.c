#include "sample.h"

enum { NOT_THERE = 7 };

static size_t none(size_t n)
{
    return n + NOT_THERE;
}

/* The first place of what is wanted in an ascending list, else n + 7. */
size_t et_sample_find(const int *x, size_t n, int wanted)
{
    size_t lo = 0, hi = n;

    while (lo < hi) {
        const size_t mid = lo + (hi - lo) / 2;
        if (x[mid] < wanted)
            lo = mid + 1;
        else
            hi = mid;
    }
    return lo < n && x[lo] == wanted ? lo : none(n);
}

int et_sample_clamp(int x, int lo, int hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

double et_sample_mean(const double *x, size_t n)
{
    double sum = 0;

    if (n == 0)
        return -1;
    for (size_t i = 0; i < n; i++)
        sum += x[i];
    return sum / (double)n;
}

/* Its second line is never run by a test, and what its first says is never looked at. */
int et_sample_untested(int a)
{
    if (a > 1000)
        return a * 3;
    a -= 5;
    return a;
}
