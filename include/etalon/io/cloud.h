/* cloud: point clouds in files: XYZ/CSV, PLY, OBJ, STL, PCD.
 *
 * A cloud is a list of points (x, y, z) of finite doubles in the file's own units and order.  Decimal numbers are read as strtod reads
 * them, correctly rounded, with a decimal point whatever the locale.  docs/cloud.md tells what is read of each format and what is refused. */
#ifndef ETALON_IO_CLOUD_H
#define ETALON_IO_CLOUD_H
#include "etalon/base/status.h"
#include "etalon/base/vec3.h"
#ifdef __cplusplus
extern "C" {
#endif

/* points[0 .. count-1]; points is null when count is 0. */
typedef struct { et_vec3 *points; size_t count; } et_cloud;

/* Read a cloud, points in the order of the file.
 *
 * The format is told from the content (PLY, STL, PCD) and else from the ending (.obj; anything else is XYZ/CSV: blanks, or one of , ; | : & ! ^ ~
 * between columns, #, // or % comments, extra columns ignored, one header line allowed, and one line with the count before it).
 * "-" is standard input.  Of PLY the element vertex is read (ascii, binary of either byte order), of OBJ the lines v, of STL each distinct
 * vertex once, of PCD the data `ascii`.
 *
 * ET_EINVAL: a null argument.  ET_EFORMAT with `FILE:LINE: ...` (binary data: `FILE: vertex K ...`) for the first fault: too few
 * columns, not a number, NaN, infinite, a count that does not fit, truncated, a NUL byte or a line of more than 64 MiB in a text; and
 * when there is no point at all.  ET_EIO `cannot read FILE: reason`.  ET_ENOMEM.  What a file declares is not allocated before it is there.
 * Time O(bytes); memory at most 48 bytes a point (24 at the end) and the longest line. */
/*@ requires cloud:     \valid(cloud);
    requires path:      path == \null || valid_read_string(path);
    requires message:   message == \null || \valid(message);
    requires separated: \separated(cloud, message);
    assigns  *cloud, *message;
    ensures  status:    \result == ET_OK || \result == ET_EINVAL || \result == ET_EFORMAT || \result == ET_EIO || \result == ET_ENOMEM;
    ensures  some:      \result == ET_OK ==> cloud->count >= 1 && \valid(cloud->points + (0 .. cloud->count - 1));
    ensures  finite:    \result == ET_OK ==> \forall integer k; 0 <= k < cloud->count ==> \is_finite(cloud->points[k].x) &&
                        \is_finite(cloud->points[k].y) && \is_finite(cloud->points[k].z);
    ensures  unchanged: \result != ET_OK ==> *cloud == \old(*cloud);
*/
et_status et_cloud_read(et_cloud *cloud, const char *path, et_message *message);

/* Free the points and zero the cloud; does nothing for null.
 * Golden: none (frees memory) */
/*@ requires cloud:     cloud == \null || \valid(cloud);
    assigns  *cloud;
    ensures  zeroed:    cloud != \null ==> cloud->points == \null && cloud->count == 0;
*/
void et_cloud_free(et_cloud *cloud);

typedef enum { ET_CLOUD_XYZ = 0, ET_CLOUD_PLY_ASCII, ET_CLOUD_PLY_LITTLE, ET_CLOUD_PLY_BIG } et_cloud_format;

/* "xyz", "ply-ascii", "ply", "ply-big"; null past the last. */
/*@ assigns  \result \from format;
    ensures  name:      ET_CLOUD_XYZ <= format <= ET_CLOUD_PLY_BIG ==> valid_read_string(\result);
    ensures  none:      !(ET_CLOUD_XYZ <= format <= ET_CLOUD_PLY_BIG) ==> \result == \null;
*/
const char *et_cloud_name(et_cloud_format format);

/* Write points[0 .. count-1] through et_file_create ("-" is standard output).  Text holds for each number the shortest of 15, 16 and 17
 * significant digits that is read as the same double; PLY has the properties double x, y, z: every double round-trips.
 * A path ending in .ply with ET_CLOUD_XYZ is written as ET_CLOUD_PLY_LITTLE by the command line, not here.
 *
 * ET_EINVAL: a null argument, count == 0, a point not finite, an unknown format.  ET_EIO, ET_ENOMEM: an earlier file is intact. */
/*@ requires path:      path == \null || valid_read_string(path);
    requires points:    points == \null || \valid_read(points + (0 .. count - 1));
    requires message:   message == \null || \valid(message);
    assigns  *message;
    ensures  status:    \result == ET_OK || \result == ET_EINVAL || \result == ET_EIO || \result == ET_ENOMEM;
    ensures  refused:   path == \null || points == \null || count == 0 ==> \result == ET_EINVAL;
*/
et_status et_cloud_write(const char *path, const et_vec3 *points, size_t count, et_cloud_format format, et_message *message);

#ifdef __cplusplus
}
#endif
#endif
