/* A file by the block: its bytes, the numbers they are, and its lines. */
#include "io/cloud_parts.h"
#include <errno.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST = 1 << 26 };        /* bytes of the longest line read */

et_status cloud_out_of_memory(const cloud_reader *r)
{
    return et_status_fail(r->message, ET_ENOMEM, "out of memory while reading %s", r->path);
}

static et_status fill(cloud_reader *r)
{
    if (r->start > 0) {
        memmove(r->buffer, r->buffer + r->start, r->end - r->start);
        r->end -= r->start;
        r->start = 0;
    }
    if (r->end == r->room) {
        if (r->room >= LONGEST)
            return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: line of more than %d bytes", r->path, r->following, (int)LONGEST);
        unsigned char *buffer = realloc(r->buffer, 2 * r->room + 1);
        if (!buffer)
            return cloud_out_of_memory(r);
        r->buffer = buffer;
        r->room *= 2;
    }
    errno = 0;
    size_t wanted = r->room - r->end;
    size_t got = fread(r->buffer + r->end, 1, wanted, r->in);
    r->end += got;
    if (got < wanted) {
        if (ferror(r->in))
            return et_status_fail(r->message, ET_EIO, "cannot read %s: %s", r->path, errno ? strerror(errno) : "read error");
        r->ended = 1;
    }
    return ET_OK;
}

et_status cloud_need(cloud_reader *r, size_t n, int *there)
{
    et_status status = ET_OK;
    while (!status && r->end - r->start < n && !r->ended)
        status = fill(r);
    *there = r->end - r->start >= n;
    return status;
}

et_status cloud_skip(cloud_reader *r, size_t n, int *there)
{
    et_status status = ET_OK;
    *there = 1;
    while (!status && n > 0 && *there) {
        status = cloud_need(r, 1, there);
        size_t part = r->end - r->start < n ? r->end - r->start : n;
        r->start += part;
        n -= part;
    }
    return status;
}

uint64_t cloud_bits(const unsigned char *p, size_t size, int big)
{
    uint64_t bits = 0;
    for (size_t k = 0; k < size; k++)
        bits = bits << 8 | p[big ? k : size - 1 - k];
    return bits;
}

double cloud_float(uint64_t bits)
{
    uint32_t word = (uint32_t)bits;
    float x;
    memcpy(&x, &word, sizeof x);
    return (double)x;
}

/* Pass the line end at buffer[k]; *k: the byte after it. */
static et_status pass_line_end(cloud_reader *r, size_t *k)
{
    r->cr_ended = 0;
    if (r->buffer[(*k)++] == '\n')
        return ET_OK;
    r->cr_ended = 1;
    if (r->bare_cr)
        return ET_OK;
    size_t done = *k - r->start;
    int there;
    et_status status = cloud_need(r, done + 1, &there);
    *k = r->start + done;
    if (!status && there && r->buffer[*k] == '\n') {
        (*k)++;
        r->cr_ended = 0;
    }
    return status;
}

et_status cloud_next_line(cloud_reader *r, cloud_field *line, int *more)
{
    et_status status;
    size_t k = r->start, first = r->following;
    r->line = first;
    for (;;) {
        while (k < r->end && r->buffer[k] > '\r')
            k++;
        size_t done = k - r->start;
        if (k == r->end) {
            if (r->ended)
                break;
            if ((status = fill(r)) != ET_OK)
                return status;
            k = r->start + done;
        } else if (r->buffer[k] == '\n' || r->buffer[k] == '\r') {
            size_t after = k;
            if ((status = pass_line_end(r, &after)) != ET_OK)
                return status;
            r->following++;
            line->begin = (char *)r->buffer + r->start;
            line->end = line->begin + done;
            k = r->start + done;
            if (!r->continued || done == 0 || r->buffer[k - 1] != '\\') {
                r->start = after;
                *more = 1;
                return ET_OK;
            }
            memset(r->buffer + k - 1, ' ', after - k + 1);
        } else if (r->buffer[k] == 0) {
            return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: NUL byte in a text file", r->path, r->following);
        } else {
            k++;
        }
    }
    if (r->continued && k > r->start && r->buffer[k - 1] == '\\')
        r->buffer[k - 1] = ' ';
    *more = k > r->start;
    r->following += *more ? 1 : 0;
    line->begin = (char *)r->buffer + r->start;
    line->end = (char *)r->buffer + k;
    r->start = k;
    return ET_OK;
}
