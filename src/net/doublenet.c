#include "etalon/net/doublenet.h"

static size_t distance(size_t a, size_t b)
{
    return a < b ? b - a : a - b;
}

static int on_border(et_doublenet net, size_t i, size_t j)
{
    return i == 0 || i == net.nx - 1 || j == 0 || j == net.ny - 1;
}

int et_doublenet_valid(et_doublenet net)
{
    return net.nx >= 2 && net.ny >= 2 && net.nx <= SIZE_MAX / 2 / net.ny;
}

size_t et_doublenet_non(et_doublenet net)
{
    return 2 * net.nx * net.ny;
}

size_t et_doublenet_nov(et_doublenet net)
{
    return net.nx * net.ny + (net.nx - 2) * (net.ny - 2);
}

size_t et_doublenet_nor(et_doublenet net)
{
    return 2 * net.nx + 2 * (net.ny - 2);
}

size_t et_doublenet_class(et_doublenet net, size_t view, size_t i, size_t j)
{
    if (view == ET_BOTTOM || on_border(net, i, j))
        return i * net.ny + j + 1;
    return net.nx * net.ny + (i - 1) * (net.ny - 2) + (j - 1) + 1;
}

et_index et_doublenet_index(et_doublenet net, size_t c)
{
    const size_t bottom = net.nx * net.ny;
    et_index v;

    if (c <= bottom) {
        v.i = (c - 1) / net.ny;
        v.j = (c - 1) % net.ny;
        v.k = on_border(net, v.i, v.j) ? 1 : 0;
    } else {
        v.i = (c - 1 - bottom) / (net.ny - 2) + 1;
        v.j = (c - 1 - bottom) % (net.ny - 2) + 1;
        v.k = 2;
    }
    return v;
}

void et_doublenet_corners(size_t c[4], et_doublenet net)
{
    c[0] = 1;
    c[1] = net.ny;
    c[2] = net.ny * (net.nx - 1) + 1;
    c[3] = net.nx * net.ny;
}

void et_doublenet_seam(size_t *c, size_t nor, et_doublenet net)
{
    size_t i = 0, j = 0;

    for (size_t s = 0; s < nor; s++) {
        c[s] = i * net.ny + j + 1;
        if (i == 0 && j < net.ny - 1)
            j++;
        else if (j == net.ny - 1 && i < net.nx - 1)
            i++;
        else if (i == net.nx - 1 && j > 0)
            j--;
        else
            i--;
    }
}

size_t et_doublenet_dist2(et_index a, et_index b)
{
    const size_t i = distance(a.i, b.i), j = distance(a.j, b.j), k = distance(a.k, b.k);

    return i * i + j * j + k * k;
}

int et_doublenet_adjacent(et_index a, et_index b)
{
    const size_t i = distance(a.i, b.i), j = distance(a.j, b.j);

    /* each side first, so that the sum cannot wrap */
    return i <= 1 && j <= 1 && i + j <= 1 && distance(a.k, b.k) <= 1;
}
