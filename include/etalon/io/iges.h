/* iges: IGES 5.3 files with one rational B-spline surface entity (type 128) a view. */
#ifndef ETALON_IO_IGES_H
#define ETALON_IO_IGES_H
#include "etalon/base/frame.h"
#include "etalon/fit/shell.h"
#ifdef __cplusplus
extern "C" {
#endif

/* Two 128 entities, in the cloud's own coordinates (frame applied).  The file does not depend on the clock. */
et_status et_iges_write(const char *path, const et_shell *shell, const et_frame *frame, et_message *message);

#ifdef __cplusplus
}
#endif
#endif
