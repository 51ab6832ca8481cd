#include "eva.h"

static void evaluate(size_t p, size_t q, int rational)
{
    et_surface s, t;
    et_vec3 D[6], S[4], n;
    const double u[2] = {any(), any()}, v[2] = {any(), any()}, lines[2] = {0.125, 1};

    any_memory();
    if (!make_surface(&s, p, q, rational))
        return;
    et_surface_valid(&s);
    const size_t room = et_surface_work(&s), more = et_surface_partials_work(&s, 2);
    double *work = malloc(room * sizeof *work), *wide = malloc(more * sizeof *wide);
    if (work && wide) {
        S[0] = et_surface_point(&s, u[0], v[0], work, room);
        et_surface_points(S, &s, u, v, 2, work, room);
        et_surface_ders(D, &s, u[0], v[0], work, room);
        et_surface_partials(D, 2, &s, u[0], v[0], ET_SIDE_LEFT, ET_SIDE_RIGHT, wide, more);
        et_surface_normal(&n, &s, u[0], v[0], work, room);
    }
    free(work);
    free(wide);
    et_surface_grid(S, &s, u, 2, lines, 2);
    if (et_surface_copy(&t, &s) == ET_OK)
        et_surface_free(&t);
    et_surface_free(&s);
}

static void insert(size_t p, size_t q, int rational, et_direction along)
{
    et_surface s, t;

    any_memory();
    if (!make_surface(&s, p, q, rational))
        return;
    if (et_surface_insert(&t, &s, along, 0.25, 2) == ET_OK)
        et_surface_free(&t);
    et_surface_free(&s);
}

static void removed(size_t p, size_t q, int rational, et_direction along)
{
    et_surface s, t;
    size_t n;

    any_memory();
    if (!make_surface(&s, p, q, rational))
        return;
    if (et_surface_remove(&t, &n, &s, along, 0.5, 1, 1.0) == ET_OK)
        et_surface_free(&t);
    et_surface_free(&s);
}

static void elevate(size_t p, size_t q, int rational, et_direction along)
{
    et_surface s, t;

    any_memory();
    if (!make_surface(&s, p, q, rational))
        return;
    if (et_surface_elevate(&t, &s, along, 1) == ET_OK)
        et_surface_free(&t);
    et_surface_free(&s);
}

void eva_surface_0_2(void) { evaluate(0, 2, 0); }
void eva_surface_2_1(void) { evaluate(2, 1, 0); }
void eva_surface_1_2_rational(void) { evaluate(1, 2, 1); }
void eva_surface_insert_u(void) { insert(2, 1, 0, ET_ALONG_U); }
void eva_surface_insert_v_rational(void) { insert(1, 2, 1, ET_ALONG_V); }
void eva_surface_remove_u_rational(void) { removed(2, 1, 1, ET_ALONG_U); }
void eva_surface_remove_v(void) { removed(1, 2, 0, ET_ALONG_V); }
void eva_surface_elevate_u_rational(void) { elevate(2, 1, 1, ET_ALONG_U); }
void eva_surface_elevate_v(void) { elevate(1, 2, 0, ET_ALONG_V); }
