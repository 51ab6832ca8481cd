/* XYZ and CSV: a point a line, x, y and z in the first three columns or in those that a header names. */
#include "io/cloud_parts.h"
#include <string.h>

typedef struct {
    size_t column[3];             /* of x, y, z */
    char separator;               /* the header's, 0 without a header */
    int first;                    /* no header and no point yet */
    size_t count, count_line;     /* the count before the points, and its line; line 0 without a count */
} table_form;

static cloud_field without_comment(cloud_field line)
{
    size_t n = (size_t)(line.end - line.begin);
    char *p = memchr(line.begin, '#', n);
    if (p)
        line.end = p;
    for (p = line.begin; p < line.end && (p = memchr(p, '/', (size_t)(line.end - p))) != NULL; p++) {
        if (p + 1 < line.end && p[1] == '/') {
            line.end = p;
            break;
        }
    }
    line = cloud_trimmed(line);
    if (line.begin < line.end && *line.begin == '%')
        line.end = line.begin;
    return line;
}

static int has(cloud_field f, char c)
{
    while (f.begin < f.end && *f.begin != c)
        f.begin++;
    return f.begin < f.end;
}

/* Signs that may stand between columns beside blanks: none that a number, a comment or a name could hold. */
static const char separators[] = ";,|:&!^~";

static int is_separator(char c)
{
    return c != '\0' && strchr(separators, c) != NULL;
}

/* What stands between the columns: the first separator or blanks after the first field decide (a header's own where it occurs). */
static char separator_of(const table_form *form, cloud_field line)
{
    if (form->separator && form->separator != ' ' && has(line, form->separator))
        return form->separator;
    char *p = line.begin;
    while (p < line.end && !cloud_blank(*p) && !is_separator(*p))
        p++;
    while (p < line.end && cloud_blank(*p))
        p++;
    return p < line.end && is_separator(*p) ? *p : ' ';
}

static cloud_field unquoted(cloud_field f)
{
    if (f.end - f.begin >= 2 && *f.begin == '"' && f.end[-1] == '"')
        f = cloud_trimmed((cloud_field){ f.begin + 1, f.end - 1 });
    return f;
}

/* Whether a number stands between any separators of the line: then it is no header. */
static int holds_number(cloud_field line)
{
    double value;
    cloud_field f = { line.begin, line.begin };
    for (; f.begin < line.end; f.begin = f.end = f.end + 1) {
        while (f.end < line.end && !cloud_blank(*f.end) && !is_separator(*f.end))
            f.end++;
        if (cloud_number(&value, f))
            return 1;
    }
    return 0;
}

/* Whether the line is a header; takes the columns from it where it names x, y and z. */
static et_status take_header(cloud_reader *r, table_form *form, cloud_field line, int *header)
{
    static const char *const name[3] = { "x", "y", "z" };
    size_t column[3] = { 0, 0, 0 }, found[3] = { 0, 0, 0 };
    char separator = ' ';
    cloud_field f, rest = line;
    for (size_t k = 0; separator == ' ' && separators[k] != '\0'; k++)
        if (has(line, separators[k]))
            separator = separators[k];
    *header = !holds_number(line);
    for (size_t k = 0; *header && cloud_next_field(&f, &rest, separator); k++) {
        for (size_t axis = 0; axis < 3; axis++) {
            if (cloud_field_is(unquoted(f), name[axis])) {
                column[axis] = k;
                found[axis]++;
            }
        }
    }
    if (found[0] || found[1] || found[2]) {
        for (size_t axis = 0; axis < 3; axis++) {
            if (found[axis] != 1)
                return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: the header names %s %s", r->path, r->line, name[axis],
                                      found[axis] ? "twice" : "not at all, but another of x, y, z");
        }
        memcpy(form->column, column, sizeof column);
    }
    form->separator = *header ? separator : 0;
    return ET_OK;
}

static et_status table_point(cloud_reader *r, const table_form *form, et_vec3 *p, cloud_field line)
{
    cloud_field f, at[3] = { { NULL, NULL }, { NULL, NULL }, { NULL, NULL } };
    char separator = separator_of(form, line);
    size_t missing = 3;
    for (size_t k = 0; missing > 0 && cloud_next_field(&f, &line, separator); k++) {
        for (size_t axis = 0; axis < 3; axis++) {
            if (form->column[axis] == k) {
                at[axis] = f;
                missing--;
            }
        }
    }
    et_status status = ET_OK;
    for (size_t axis = 0; axis < 3 && !status; axis++)
        status = cloud_coordinate(r, p, axis, at[axis]);
    return status;
}

et_status cloud_read_table(cloud_reader *r, cloud_builder *b)
{
    table_form form = { { 0, 1, 2 }, 0, 1, 0, 0 };
    et_vec3 p = { 0, 0, 0 };
    et_status status;
    cloud_field line;
    int more, header = 0;
    while ((status = cloud_next_line(r, &line, &more)) == ET_OK && more) {
        line = without_comment(line);
        if (line.begin == line.end)
            continue;
        if (form.first && !form.count_line && cloud_count(&form.count, line)) {
            form.count_line = r->line;
            continue;
        }
        if (form.first) {
            form.first = 0;
            if ((status = take_header(r, &form, line, &header)) != ET_OK)
                return status;
            if (header)
                continue;
        }
        if ((status = table_point(r, &form, &p, line)) != ET_OK || (status = cloud_append(r, b, p)) != ET_OK)
            return status;
    }
    if (!status && form.count_line && form.count != b->count)
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: the count is %zu, but %zu points follow", r->path, form.count_line, form.count,
                              b->count);
    return status;
}
