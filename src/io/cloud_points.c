/* Points: the list that grows as a file is read, in which a point may be asked to stand once only. */
#include "io/cloud_parts.h"
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

double *cloud_axis(et_vec3 *p, size_t axis)
{
    return axis == 0 ? &p->x : axis == 1 ? &p->y : &p->z;
}

char cloud_not_finite(et_vec3 p)
{
    return !isfinite(p.x) ? 'x' : !isfinite(p.y) ? 'y' : !isfinite(p.z) ? 'z' : 0;
}

et_status cloud_append(cloud_reader *r, cloud_builder *b, et_vec3 p)
{
    if (b->count == b->room) {
        size_t room = b->room ? 2 * b->room : 1024;
        et_vec3 *points = room <= SIZE_MAX / 2 / sizeof *points ? realloc(b->points, room * sizeof *points) : NULL;
        if (!points)
            return cloud_out_of_memory(r);
        b->points = points;
        b->room = room;
    }
    b->points[b->count++] = p;
    return ET_OK;
}

static uint64_t mix(uint64_t h, double x)
{
    uint64_t bits;
    x += 0.0;                     /* -0 and 0 are one coordinate */
    memcpy(&bits, &x, sizeof bits);
    h = (h ^ bits) * UINT64_C(0x9e3779b97f4a7c15);
    return h ^ (h >> 29);
}

/* The slot that holds p, or the empty one where it belongs. */
static size_t place_of(const cloud_builder *b, et_vec3 p)
{
    uint64_t h = mix(mix(mix(0, p.x), p.y), p.z);
    size_t k = (size_t)(h ^ (h >> 32)) & (b->slots - 1);
    while (b->slot[k]) {
        const et_vec3 *q = &b->points[b->slot[k] - 1];
        if (q->x == p.x && q->y == p.y && q->z == p.z)
            break;
        k = (k + 1) & (b->slots - 1);
    }
    return k;
}

et_status cloud_append_distinct(cloud_reader *r, cloud_builder *b, et_vec3 p)
{
    if (2 * (b->count + 1) > b->slots) {
        size_t slots = b->slots ? 2 * b->slots : 4096;
        size_t *slot = calloc(slots, sizeof *slot);
        if (!slot)
            return cloud_out_of_memory(r);
        free(b->slot);
        b->slot = slot;
        b->slots = slots;
        for (size_t i = 0; i < b->count; i++)
            b->slot[place_of(b, b->points[i])] = i + 1;
    }
    size_t k = place_of(b, p);
    if (b->slot[k])
        return ET_OK;
    b->slot[k] = b->count + 1;
    return cloud_append(r, b, p);
}
