#include "etalon/base/status.h"
#include <stdarg.h>
#include <stdio.h>

const char *et_status_text(et_status status)
{
    switch (status) {
    case ET_OK:
        return "done";
    case ET_EINVAL:
        return "invalid argument";
    case ET_EFORMAT:
        return "unusable input data";
    case ET_EIO:
        return "file cannot be read or written";
    case ET_ENOMEM:
        return "out of memory";
    case ET_ERANK:
        return "linear system is rank deficient";
    case ET_ENOCONV:
        return "iteration did not converge";
    case ET_ESTOPPED:
        return "stopped on request";
    case ET_EINTERNAL:
        return "internal fault";
    case ET_EDIFFER:
        return "figures differ";
    }
    return "unknown status";
}

int et_status_exit(et_status status)
{
    switch (status) {
    case ET_OK:
        return 0;
    case ET_EDIFFER:
        return 1;
    case ET_EINVAL:
        return 2;
    case ET_EFORMAT:
        return 3;
    case ET_EIO:
        return 4;
    case ET_ERANK:
    case ET_ENOCONV:
        return 5;
    case ET_ESTOPPED:
        return 130;
    case ET_ENOMEM:
    case ET_EINTERNAL:
        return 70;
    }
    return 70;
}

et_status et_status_fail(et_message *message, et_status status, const char *format, ...)
{
    if (message) {
        va_list arguments;
        va_start(arguments, format);
        if (vsnprintf(message->text, sizeof message->text, format, arguments) < 0) {
            message->text[0] = '\0';
        }
        va_end(arguments);
    }
    return status;
}
