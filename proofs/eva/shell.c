#include "eva.h"
#include "etalon/fit/seam.h"

static void storage(size_t p, size_t q, int rational)
{
    et_shell s, t;
    et_vec3 points[72];

    any_memory();
    if (!make_shell(&s, p, q, rational))
        return;
    et_shell_valid(&s);
    et_shell_gather(points, et_doublenet_nov(et_shell_net(&s)), &s);
    et_shell_scatter(&s, points, et_doublenet_nov(et_shell_net(&s)));
    if (et_shell_copy(&t, &s) == ET_OK)
        et_shell_free(&t);
    et_shell_free(&s);
    et_shell_free(&s);
}

static void seam(size_t p, size_t q, int rational)
{
    et_shell s;
    et_seam gap;

    any_memory();
    if (!make_shell(&s, p, q, rational))
        return;
    et_shell_glued(&s);
    et_shell_closed(&s);
    et_seam_gap(&gap, &s, 2);
    et_shell_free(&s);
}

void eva_shell_1_2(void) { storage(1, 2, 0); }
void eva_shell_2_1_rational(void) { storage(2, 1, 1); }
void eva_seam_1_2(void) { seam(1, 2, 0); }
void eva_seam_2_1_rational(void) { seam(2, 1, 1); }
