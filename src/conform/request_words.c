#include "conform/request_words.h"
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const uint64_t greatest = UINT64_C(1) << 53;

static int separates(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

size_t request_words_next(const char **word, request_words *words)
{
    while (separates(*words->at))
        words->at++;
    *word = words->at;
    while (*words->at && !separates(*words->at))
        words->at++;
    return (size_t)(words->at - *word);
}

int request_words_count(uint64_t *value, const char *word, size_t length)
{
    uint64_t n = 0;

    for (size_t k = 0; k < length; k++) {
        if (word[k] < '0' || word[k] > '9')
            return 0;
        n = 10 * n + (uint64_t)(word[k] - '0');
        if (n > greatest)
            return 0;
    }
    if (length > 0)
        *value = n;
    return length > 0;
}

int request_words_real(double *value, const char *word, size_t length)
{
    char *end;

    /* strtod would pass over other white space. */
    if (length == 0 || !strchr("0123456789+-.iInN", word[0]))
        return 0;
    const double x = strtod(word, &end);
    if (end != word + length)
        return 0;
    *value = x;
    return 1;
}

et_status request_words_point(locale_t *c, locale_t *before)
{
    *c = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (*c == (locale_t)0)
        return ET_ENOMEM;
    *before = uselocale(*c);
    return ET_OK;
}

void request_words_point_end(locale_t c, locale_t before)
{
    (void)uselocale(before);
    freelocale(c);
}

static void put(request_line *line, const char *text, size_t length)
{
    if (line->failed)
        return;
    if (length >= line->room - line->length) {
        const size_t room = 2 * line->room + length + 64;
        char *more = room > line->room ? realloc(line->text, room) : NULL;
        if (!more) {
            line->failed = 1;
            return;
        }
        line->text = more;
        line->room = room;
    }
    memcpy(line->text + line->length, text, length);
    line->length += length;
    line->text[line->length] = '\0';
}

void request_line_text(request_line *line, const char *text)
{
    put(line, text, strlen(text));
}

void request_line_count(request_line *line, uint64_t value)
{
    char text[24];

    put(line, text, (size_t)snprintf(text, sizeof text, "%" PRIu64, value));
}

void request_line_real(request_line *line, double x)
{
    char text[40];
    uint64_t bits;

    if (!isfinite(x)) {
        request_line_text(line, isnan(x) ? "nan" : x < 0 ? "-inf" : "inf");
        return;
    }
    memcpy(&bits, &x, sizeof bits);
    const int exponent = (int)(bits >> 52 & 0x7ff);
    uint64_t fraction = bits & ((UINT64_C(1) << 52) - 1);
    int digits = fraction ? 13 : 0;
    const int power = exponent ? exponent - 1023 : fraction ? -1022 : 0;

    for (; digits > 0 && !(fraction & 15); digits--)
        fraction >>= 4;
    int length = snprintf(text, sizeof text, "%s0x%d", bits >> 63 ? "-" : "", exponent != 0);
    if (digits)
        length += snprintf(text + length, sizeof text - (size_t)length, ".%0*" PRIx64, digits, fraction);
    length += snprintf(text + length, sizeof text - (size_t)length, "p%+d", power);
    put(line, text, (size_t)length);
}

et_status request_line_end(char **text, request_line *line)
{
    put(line, "", 0);
    if (line->failed) {
        free(line->text);
        return ET_ENOMEM;
    }
    *text = line->text;
    return ET_OK;
}
