#include "etalon/io/json.h"
#include "etalon/io/file.h"
#include "io/json_parts.h"
#include <errno.h>
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { VERSION = 1 };

static const char net_format[] = "etalon-net", surface_format[] = "etalon-surface";

/* Exactly one of net and surface is given.  Reals are written with a point, whatever the locale of the program. */
static et_status write_file(const char *path, const et_net_file *net, const et_surface_file *surface, et_message *message)
{
    et_file file;
    et_status status = et_file_create(&file, path, message);
    if (status)
        return status;
    locale_t c = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (c == (locale_t)0) {
        et_file_abandon(&file);
        return et_status_fail(message, ET_ENOMEM, "out of memory");
    }
    locale_t before = uselocale(c);
    fprintf(file.stream, "{\n  \"format\": \"%s\",\n  \"version\": %d,\n", net ? net_format : surface_format, (int)VERSION);
    if (net)
        json_file_put_net(file.stream, net);
    else
        json_file_put_surface(file.stream, surface);
    (void)uselocale(before);
    freelocale(c);
    return et_file_commit(&file, message);
}

et_status et_json_write_net(const char *path, const et_net_file *net, et_message *message)
{
    if (!path || !net || !json_file_net_valid(net))
        return et_status_fail(message, ET_EINVAL, "no file, or a net with a value that no net file holds");
    return write_file(path, net, NULL, message);
}

et_status et_json_write_surface(const char *path, const et_surface_file *surface, et_message *message)
{
    if (!path || !surface || !json_file_surface_valid(surface))
        return et_status_fail(message, ET_EINVAL, "no file, or a surface with a value that no surface file holds");
    return write_file(path, NULL, surface, message);
}

static const char *shown(const char *path)
{
    return path && strcmp(path, "-") == 0 ? "standard input" : path;
}

/* The document of a file, of the wanted format and version. */
static et_status load(const json_file_source *d, json_t **document, const char *path, const char *format)
{
    json_error_t error;
    int standard = strcmp(path, "-") == 0;
    FILE *in = standard ? stdin : fopen(path, "rb");
    if (!in)
        return et_status_fail(d->message, errno == ENOMEM ? ET_ENOMEM : ET_EIO, "cannot read %s: %s", d->path, strerror(errno));
    errno = 0;
    json_t *loaded = json_loadf(in, JSON_REJECT_DUPLICATES, &error);
    int reason = errno, failed = ferror(in);
    if (!standard)
        (void)fclose(in);
    if (failed || !loaded) {
        json_decref(loaded);
        if (failed)
            return et_status_fail(d->message, ET_EIO, "cannot read %s: %s", d->path, reason ? strerror(reason) : "read error");
        if (json_error_code(&error) == json_error_out_of_memory)
            return json_file_no_memory(d);
        return et_status_fail(d->message, ET_EFORMAT, "%s:%d: %s", d->path, error.line, error.text);
    }
    json_file_place top = { loaded, "" }, at;
    et_status status = json_file_member(d, &at, &top, "format");
    if (!status && (!json_is_string(at.value) || strcmp(json_string_value(at.value), format) != 0))
        status = et_status_fail(d->message, ET_EFORMAT, "%s: format: is not \"%s\"", d->path, format);
    if (!status)
        status = json_file_member(d, &at, &top, "version");
    if (!status && (!json_is_integer(at.value) || json_integer_value(at.value) != VERSION))
        status = et_status_fail(d->message, ET_EFORMAT, "%s: version: is not %d", d->path, (int)VERSION);
    if (status) {
        json_decref(loaded);
        return status;
    }
    *document = loaded;
    return ET_OK;
}

et_status et_json_read_net(et_net_file *net, const char *path, et_message *message)
{
    json_file_source d = { shown(path), message };
    et_net_file read;
    json_t *document = NULL;
    if (!net || !path)
        return et_status_fail(message, ET_EINVAL, "no file to read");
    memset(&read, 0, sizeof read);
    et_status status = load(&d, &document, path, net_format);
    if (status)
        return status;
    json_file_place top = { document, "" };
    status = json_file_read_net(&d, &read, &top);
    json_decref(document);
    if (status)
        et_json_free_net(&read);
    else
        *net = read;
    return status;
}

void et_json_free_net(et_net_file *net)
{
    if (!net)
        return;
    free(net->weights);
    memset(net, 0, sizeof *net);
}

et_status et_json_read_surface(et_surface_file *surface, const char *path, et_message *message)
{
    json_file_source d = { shown(path), message };
    et_surface_file read;
    json_t *document = NULL;
    if (!surface || !path)
        return et_status_fail(message, ET_EINVAL, "no file to read");
    memset(&read, 0, sizeof read);
    et_status status = load(&d, &document, path, surface_format);
    if (status)
        return status;
    json_file_place top = { document, "" };
    status = json_file_read_surface(&d, &read, &top);
    json_decref(document);
    if (status)
        et_json_free_surface(&read);
    else
        *surface = read;
    return status;
}

void et_json_free_surface(et_surface_file *surface)
{
    if (!surface)
        return;
    et_fit_free(&surface->fit);
    free(surface->uv);
    memset(surface, 0, sizeof *surface);
}
