#include "etalon/fit/shell.h"
#include <string.h>

/*@ requires valid: \valid_read(a) && \valid_read(b);
    assigns  \nothing;
    ensures  truth: \result == 0 || \result == 1;
    ensures  same:  \result == 1 <==> a->p == b->p && a->q == b->q && a->nu == b->nu && a->nv == b->nv &&
                                       (a->weights == \null <==> b->weights == \null);
*/
static int same_shape(const et_surface *a, const et_surface *b)
{
    return a->p == b->p && a->q == b->q && a->nu == b->nu && a->nv == b->nv && (a->weights == NULL) == (b->weights == NULL);
}

int et_shell_valid(const et_shell *shell)
{
    const et_surface *a = &shell->view[ET_BOTTOM], *b = &shell->view[ET_TOP];

    return et_surface_valid(a) && et_surface_valid(b) && same_shape(a, b) && et_doublenet_valid(et_shell_net(shell));
}

/* Compared as bits: 0 and -0 are different, so that equal borders give equal bits wherever they are used. */
/*@ requires valid: \valid_read(a + (0 .. n - 1)) && \valid_read(b + (0 .. n - 1)) && 8*n <= SIZE_MAX;
    assigns  \nothing;
    ensures  truth: \result == 0 || \result == 1;
    ensures  equal: \result == 1 ==> \forall integer i; 0 <= i < n && \is_finite(a[i]) ==> \is_finite(b[i]) && a[i] == b[i];
*/
static int same_bits(const double *a, const double *b, size_t n)
{
    return memcmp(a, b, n * sizeof *a) == 0;
}

/*@ requires valid:   \valid_read(a) && \valid_read(b) && \valid_read(a->points + at) && \valid_read(b->points + at);
    requires weights: a->weights == \null || (\valid_read(a->weights + at) && \valid_read(b->weights + at) && \is_finite(a->weights[at]));
    requires finite:  \is_finite(a->points[at].x) && \is_finite(a->points[at].y) && \is_finite(a->points[at].z);
    assigns  \nothing;
    ensures  truth:   \result == 0 || \result == 1;
    ensures  equal:   \result == 1 ==> a->points[at].x == b->points[at].x && a->points[at].y == b->points[at].y &&
                          a->points[at].z == b->points[at].z && (a->weights == \null || a->weights[at] == b->weights[at]);
*/
static int same_node(const et_surface *a, const et_surface *b, size_t at)
{
    const et_vec3 s = a->points[at], t = b->points[at];

    return same_bits(&s.x, &t.x, 1) && same_bits(&s.y, &t.y, 1) && same_bits(&s.z, &t.z, 1) &&
           (a->weights == NULL || same_bits(a->weights + at, b->weights + at, 1));
}

int et_shell_glued(const et_shell *shell)
{
    const et_surface *a = &shell->view[ET_BOTTOM], *b = &shell->view[ET_TOP];

    if (!et_shell_valid(shell) || !same_bits(a->u, b->u, a->nu + a->p + 1) || !same_bits(a->v, b->v, a->nv + a->q + 1))
        return 0;
    for (size_t i = 0; i < a->nu; i++)
        for (size_t j = 0; j < a->nv; j++)
            if ((i == 0 || i == a->nu - 1 || j == 0 || j == a->nv - 1) && !same_node(a, b, i * a->nv + j))
                return 0;
    return 1;
}

/* Then a border curve is that of the border's control points alone: glued control nets are glued surfaces. */
/*@ requires valid:   \valid_read(s) && et_surface_ok((et_surface *)s) && 2*s->nu <= SIZE_MAX && 2*s->nv <= SIZE_MAX;
    assigns  \nothing;
    ensures  truth:   \result == 0 || \result == 1;
    ensures  u:       \result == 1 ==> s->u[0] == s->u[s->p] < s->u[s->p + 1] && s->u[s->nu - 1] < s->u[s->nu] == s->u[s->nu + s->p];
    ensures  v:       \result == 1 ==> s->v[0] == s->v[s->q] < s->v[s->q + 1] && s->v[s->nv - 1] < s->v[s->nv] == s->v[s->nv + s->q];
*/
static int interpolating(const et_surface *s)
{
    return et_knots_interpolating(s->u, s->nu + s->p + 1, s->p) && et_knots_interpolating(s->v, s->nv + s->q + 1, s->q);
}

int et_shell_closed(const et_shell *shell)
{
    return et_shell_glued(shell) && interpolating(&shell->view[ET_BOTTOM]);
}

et_doublenet et_shell_net(const et_shell *shell)
{
    return (et_doublenet){shell->view[ET_BOTTOM].nu, shell->view[ET_BOTTOM].nv};
}

et_status et_shell_new(et_shell *shell, size_t p, size_t q, et_doublenet control, int rational)
{
    et_shell made;

    if (!et_doublenet_valid(control) || p < 1 || q < 1 || p >= control.nx || q >= control.ny)
        return ET_EINVAL;
    memset(&made, 0, sizeof made);
    for (size_t w = 0; w < 2; w++) {
        const et_status status = et_surface_new(&made.view[w], p, q, control.nx, control.ny, rational);
        if (status != ET_OK) {
            et_shell_free(&made);
            return status;
        }
    }
    *shell = made;
    return ET_OK;
}

et_status et_shell_copy(et_shell *copy, const et_shell *shell)
{
    et_shell made;

    memset(&made, 0, sizeof made);
    for (size_t w = 0; w < 2; w++) {
        const et_status status = et_surface_copy(&made.view[w], &shell->view[w]);
        if (status != ET_OK) {
            et_shell_free(&made);
            return status;
        }
    }
    *copy = made;
    return ET_OK;
}

void et_shell_free(et_shell *shell)
{
    et_surface_free(&shell->view[ET_BOTTOM]);
    et_surface_free(&shell->view[ET_TOP]);
}

void et_shell_gather(et_vec3 *points, size_t nov, const et_shell *shell)
{
    const et_doublenet net = et_shell_net(shell);

    for (size_t c = 1; c <= nov; c++) {
        const et_index k = et_doublenet_index(net, c);
        points[c - 1] = shell->view[k.k == 2 ? ET_TOP : ET_BOTTOM].points[k.i * net.ny + k.j];
    }
}

void et_shell_scatter(et_shell *shell, const et_vec3 *points, size_t nov)
{
    const et_doublenet net = et_shell_net(shell);

    (void)nov;
    for (size_t w = 0; w < 2; w++)
        for (size_t i = 0; i < net.nx; i++)
            for (size_t j = 0; j < net.ny; j++)
                shell->view[w].points[i * net.ny + j] = points[et_doublenet_class(net, w, i, j) - 1];
}
