#include "etalon/fit/shell.h"
#include <string.h>

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
static int same_bits(const double *a, const double *b, size_t n)
{
    return memcmp(a, b, n * sizeof *a) == 0;
}

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
