/* cloud: point clouds in files: XYZ/CSV, PLY, OBJ, STL, PCD. */
#ifndef ETALON_IO_CLOUD_H
#define ETALON_IO_CLOUD_H
#include "etalon/base/status.h"
#include "etalon/base/vec3.h"
#ifdef __cplusplus
extern "C" {
#endif

typedef struct { et_vec3 *points; size_t count; } et_cloud;

/* Read a cloud; the format is told from the content (PLY, STL, PCD magic) and else from the ending (.obj; anything else is XYZ/CSV: any of
 * blank, tab, comma, semicolon between columns, # or // comments, extra columns ignored, one header line allowed).  "-": standard input.
 * ET_EFORMAT with "FILE:LINE: ..." for the first bad line (too few columns, not a number, NaN, infinite, count that does not fit the
 * header, truncated binary); no point at all is ET_EFORMAT.  ET_EIO, ET_ENOMEM. */
et_status et_cloud_read(et_cloud *cloud, const char *path, et_message *message);
void et_cloud_free(et_cloud *cloud);

typedef enum { ET_CLOUD_XYZ = 0, ET_CLOUD_PLY_ASCII, ET_CLOUD_PLY_LITTLE, ET_CLOUD_PLY_BIG } et_cloud_format;
const char *et_cloud_name(et_cloud_format format);            /* "xyz", "ply-ascii", "ply", "ply-big" */

/* Write; every double round-trips.  A path ending in .ply with ET_CLOUD_XYZ is written as ET_CLOUD_PLY_LITTLE by the command line, not here. */
et_status et_cloud_write(const char *path, const et_vec3 *points, size_t count, et_cloud_format format, et_message *message);

#ifdef __cplusplus
}
#endif
#endif
