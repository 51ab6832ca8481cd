#include "base/dd_parts.h"

et_dd et_dd_two_sum(double a, double b)
{
    return dd_two_sum(a, b);
}

et_dd et_dd_two_product(double a, double b)
{
    return dd_two_product(a, b);
}

et_dd et_dd_add(et_dd a, et_dd b)
{
    return dd_add(a, b);
}

et_dd et_dd_sub(et_dd a, et_dd b)
{
    return dd_add(a, dd_negative(b));
}

et_dd et_dd_mul(et_dd a, et_dd b)
{
    return dd_mul(a, b);
}

et_dd et_dd_div(et_dd a, et_dd b)
{
    return dd_div(a, b);
}

et_dd et_dd_sqrt(et_dd a)
{
    return dd_sqrt(a);
}
