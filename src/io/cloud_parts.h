/* cloud_parts: what the files of cloud share: a file read by the block, fields of its lines, the points found so far; a reader for each format. */
#ifndef IO_CLOUD_PARTS_H
#define IO_CLOUD_PARTS_H
#include "etalon/io/cloud.h"
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

enum {
    CLOUD_BLOCK = 1 << 18, /* bytes of the buffer at first */
    CLOUD_MAGIC = 84,      /* bytes that decide the format */
    CLOUD_WORD = 48        /* bytes of a faulty field that a message shows */
};

/* A file read in blocks: the unread bytes are buffer[start .. end-1], and one byte more is always there to hold a terminator. */
typedef struct {
    FILE *in;
    const char *path;
    et_message *message;
    unsigned char *buffer;
    size_t room, start, end;
    size_t line, following; /* number of the line last given, and of the next */
    int ended;              /* nothing is left to read into the buffer */
    int continued;          /* a backslash at the end of a line joins the next to it */
    int bare_cr, cr_ended;  /* a CR alone ends a line, even before LF; the last line was ended by a CR alone */
    size_t size;            /* of a regular file, else 0 */
} cloud_reader;

/* Bytes of the buffer.  They are gone with the next line. */
typedef struct { char *begin, *end; } cloud_field;

/* The cloud being built. */
typedef struct {
    et_vec3 *points;
    size_t count, room;
    size_t *slot, slots; /* for distinct points: 1 + index, open addressing; slots is a power of two, at most half full */
} cloud_builder;

/* ---- points ---- */

/* Coordinate number `axis` (0, 1, 2) of p. */
double *cloud_axis(et_vec3 *p, size_t axis);
/* The letter of the first coordinate that is not finite, else 0. */
char cloud_not_finite(et_vec3 p);
/* Add a point. */
et_status cloud_append(cloud_reader *r, cloud_builder *b, et_vec3 p);
/* Add a point unless it is there already (by value). */
et_status cloud_append_distinct(cloud_reader *r, cloud_builder *b, et_vec3 p);

/* ---- bytes and lines ---- */

/* ET_ENOMEM, and the message. */
et_status cloud_out_of_memory(const cloud_reader *r);
/* *there: whether n bytes (at most CLOUD_BLOCK) are left; they then stand in the buffer. */
et_status cloud_need(cloud_reader *r, size_t n, int *there);
/* Pass n bytes; *there: whether there were so many. */
et_status cloud_skip(cloud_reader *r, size_t n, int *there);
/* The unsigned integer of `size` bytes at p, the highest first if big. */
uint64_t cloud_bits(const unsigned char *p, size_t size, int big);
/* The value of a 32-bit float, whose bits these are. */
double cloud_float(uint64_t bits);
/* The next line without its end (LF, CR LF or CR); *more: 0 when there is none. */
et_status cloud_next_line(cloud_reader *r, cloud_field *line, int *more);

/* ---- fields and numbers ---- */

/* Whether c is a blank within a line; here, for it is asked of every byte. */
static inline int cloud_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

/* f without blanks at its ends. */
cloud_field cloud_trimmed(cloud_field f);
/* The next field of `rest` and what is left of it; 0 when there is none.  separator: a sign, blanks around it are not part of
 * a field; or a blank, for runs of blanks. */
int cloud_next_field(cloud_field *f, cloud_field *rest, char separator);
/* Whether f is the word, capitals or not. */
int cloud_field_is(cloud_field f, const char *word);
/* The number that is the whole field: decimal, hexadecimal, inf or nan; correctly rounded.  0 when it is none. */
int cloud_number(double *value, cloud_field f);
/* A count: decimal digits only, fitting size_t.  0 when it is none. */
int cloud_count(size_t *count, cloud_field f);
/* What a message shows of f: its beginning, in printable characters. */
void cloud_show(char word[CLOUD_WORD], cloud_field f);
/* ET_EFORMAT, and the message that f is an unknown `what`. */
et_status cloud_unknown_word(cloud_reader *r, const char *what, cloud_field f);
/* Coordinate number `axis` of a point from a field of the line last read. */
et_status cloud_coordinate(cloud_reader *r, et_vec3 *p, size_t axis, cloud_field f);
/* The three coordinates from the next three fields between blanks. */
et_status cloud_three(cloud_reader *r, et_vec3 *p, cloud_field *rest);

/* ---- formats ---- */

/* The points of an XYZ or CSV file. */
et_status cloud_read_table(cloud_reader *r, cloud_builder *b);
/* The points of an OBJ file. */
et_status cloud_read_obj(cloud_reader *r, cloud_builder *b);
/* The points of a binary STL file. */
et_status cloud_read_stl_binary(cloud_reader *r, cloud_builder *b);
/* The points of an ASCII STL file. */
et_status cloud_read_stl_ascii(cloud_reader *r, cloud_builder *b);
/* The points of a PLY file. */
et_status cloud_read_ply(cloud_reader *r, cloud_builder *b);
/* The points of a PCD file. */
et_status cloud_read_pcd(cloud_reader *r, cloud_builder *b);
/* Write points in a format; an error stays in the stream. */
void cloud_put(FILE *out, const et_vec3 *points, size_t count, et_cloud_format format);
#endif
