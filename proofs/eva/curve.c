#include "eva.h"

static void evaluate(size_t p, int rational)
{
    et_curve c, d;
    const double x = any();

    any_memory();
    if (!make_curve(&c, p, rational))
        return;
    et_curve_valid(&c);
    const size_t room = et_curve_work(&c, 2);
    double *work = malloc(room * sizeof *work);
    if (work) {
        et_vec3 D[3];
        et_curve_point(&c, x, work, room);
        et_curve_ders(D, 2, &c, x, work, room);
        et_curve_ders_side(D, 2, &c, x, ET_SIDE_LEFT, work, room);
    }
    free(work);
    if (et_curve_copy(&d, &c) == ET_OK)
        et_curve_free(&d);
    et_curve_free(&c);
}

static void insert(size_t p, int rational)
{
    et_curve c, d;

    any_memory();
    if (!make_curve(&c, p, rational))
        return;
    if (et_curve_insert(&d, &c, 0.25, 2) == ET_OK)
        et_curve_free(&d);
    et_curve_free(&c);
}

static void removed(size_t p, int rational)
{
    et_curve c, d;
    size_t n;

    any_memory();
    if (!make_curve(&c, p, rational))
        return;
    if (et_curve_remove(&d, &n, &c, 0.5, 1, 1.0) == ET_OK)
        et_curve_free(&d);
    et_curve_free(&c);
}

static void elevate(size_t p, int rational)
{
    et_curve c, d;

    any_memory();
    if (!make_curve(&c, p, rational))
        return;
    if (et_curve_elevate(&d, &c, 1) == ET_OK)
        et_curve_free(&d);
    et_curve_free(&c);
}

void eva_curve_0(void) { evaluate(0, 0); }
void eva_curve_2(void) { evaluate(2, 0); }
void eva_curve_3_rational(void) { evaluate(3, 1); }
void eva_curve_insert_2(void) { insert(2, 0); }
void eva_curve_insert_3_rational(void) { insert(3, 1); }
void eva_curve_remove_2(void) { removed(2, 0); }
void eva_curve_remove_3_rational(void) { removed(3, 1); }
void eva_curve_elevate_2(void) { elevate(2, 0); }
void eva_curve_elevate_3_rational(void) { elevate(3, 1); }
