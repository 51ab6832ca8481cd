/* Contradictions, planted one a function: in each the smoke tests have to find that anything would be proved (mutants.sh). */
#include <stddef.h>

/*@ requires room:   2 <= n && \valid(a + (0 .. n - 1));
    requires rising: \forall integer i, j; 0 <= i < j < n ==> a[i] <= a[j];
    requires falls:  a[0] > a[n - 1];
    assigns  a[n - 1];
*/
void planted_sorted(int *a, size_t n) { a[n - 1] = a[0]; }

/*@ requires order:  \is_finite(x) && \is_finite(y) && x < y && y < x;
    assigns  \nothing;
*/
int planted_order(double x, double y) { return x < y; }

/*@ requires number: \is_NaN(x) && \is_finite(x);
    assigns  \nothing;
*/
int planted_number(double x) { return x < 0; }

/*@ requires room:   1 <= n && \valid_read(a + (0 .. n - 1));
    requires all:    \forall integer i; 0 <= i < n ==> \is_finite(a[i]);
    requires one:    \exists integer i; 0 <= i < n && \is_NaN(a[i]);
    assigns  \nothing;
*/
double planted_one(const double *a, size_t n) { return a[n - 1]; }

/*@ requires room:   \valid(p) && \valid(q);
    requires apart:  \separated(p, q) && p == q;
    assigns  *p;
*/
void planted_apart(int *p, const int *q) { *p = *q; }

/*@ requires some:   \exists integer k; 0 <= k < n && k >= n;
    assigns  \nothing;
*/
int planted_some(size_t n) { return n > 3; }

/*@ requires range:  1 <= a <= 5 && 1 <= b <= 5 && a * b == 0;
    assigns  \nothing;
*/
unsigned planted_product(unsigned a, unsigned b) { return a > b; }

/*@ requires parity: n <= 10 && n * 2 == 31;
    assigns  \nothing;
*/
unsigned planted_parity(unsigned n) { return n; }

/*@ assigns  \nothing;
    ensures  sign:   \result < 0 && \result > 0;
*/
int planted_callee(void);

/*@ assigns  \nothing; */
int planted_promise(void) { return planted_callee(); }
