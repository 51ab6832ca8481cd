/* io/cloud: any bytes as a file of each format. */
#include "etalon/io/cloud.h"
#include "raw.h"
#include <stdint.h>

/* Any format a cloud is written in gives the same bits back. */
static bool returns(gen *g, const et_cloud *cloud, et_cloud_format format)
{
    char path[RAW_PATH];
    et_cloud again = { NULL, 0 };
    et_message message = { "" };
    bool ok = gen_check(g, et_cloud_write(some_path(path, ".again"), cloud->points, cloud->count, format, &message) == ET_OK, "write: %s", message.text);

    ok = ok && gen_check(g, et_cloud_read(&again, path, &message) == ET_OK, "read again: %s", message.text);
    ok = ok && gen_check(g, again.count == cloud->count && memcmp(again.points, cloud->points, cloud->count * sizeof *cloud->points) == 0,
                         "%s does not give the same bits back", et_cloud_name(format));
    et_cloud_free(&again);
    unlink(path);
    return ok;
}

static verdict read_raw(gen *g, const char *ending, const sample *samples)
{
    static raw_file f;
    static et_vec3 nowhere;
    et_cloud cloud = { &nowhere, 12345 };
    et_message message = { "" };

    if (!raw_draw(g, &f, ending, samples))
        return FAIL;
    const et_status status = et_cloud_read(&cloud, f.path, &message);
    bool ok = gen_check(g, status == ET_OK || status == ET_EFORMAT, "status %s", et_status_text(status));
    gen_label(g, status == ET_OK ? "read" : "refused");
    if (status == ET_OK) {
        /* No point takes less than three bytes. */
        ok = ok && gen_check(g, cloud.count >= 1 && cloud.count <= f.n / 3, "%zu points of %zu bytes", cloud.count, f.n);
        ok = ok && gen_check(g, et_vec3_finite(cloud.points, cloud.count), "not finite");
        ok = ok && returns(g, &cloud, (et_cloud_format)(f.n % 4));
        et_cloud_free(&cloud);
    } else {
        ok = ok && gen_check(g, cloud.points == &nowhere && cloud.count == 12345, "*cloud changed") && raw_told(g, &f, &message);
        ok = ok && gen_check(g, et_cloud_read(&cloud, f.path, NULL) == status, "another status without a message");
    }
    unlink(f.path);
    return ok ? PASS : FAIL;
}

#define TEXT(s) { s, sizeof s - 1 }

verdict prop_cloud_read_raw_xyz(gen *g)
{
    static const sample some[] = {
        TEXT("1 2 3\n4 5 6\n"), TEXT("# note\n2\n0.5 -1e-3 +7.25\n1.5D+02 0x1.8p+1 .5 // 9\n"), TEXT("\xef\xbb\xbf" "x y z i\r\n1 2 3 9\r\n% 4\r\n4 5 6 9"),
        TEXT("1.7976931348623157e308 4.9e-324 -0\r2.2250738585072011e-308 1e22 9007199254740993\r"), { NULL, 0 } };

    return read_raw(g, ".xyz", some);
}

verdict prop_cloud_read_raw_csv(gen *g)
{
    static const sample some[] = {
        TEXT("1,2,3\n4,5,6\n"), TEXT("id,\"x\",\"y\",\"z\"\n1, 2 ,3,4\n"), TEXT("1;2;3\n4|5|6\n7:8:9\n1&2&3\n1!2!3\n1^2^3\n1~2~3\n"),
        TEXT("Easting [m], Northing [m], H\n500000.125,4649776.5,12.75\n"), { NULL, 0 } };

    return read_raw(g, ".csv", some);
}

#define PLY(format, rest) "ply\nformat " format " 1.0\n" rest

verdict prop_cloud_read_raw_ply(gen *g)
{
    static const sample some[] = {
        TEXT(PLY("ascii", "comment c\nelement vertex 2\nproperty float x\nproperty double y\nproperty int z\nend_header\n1 2 3\n4 5 6\n")),
        TEXT(PLY("ascii", "element face 1\nproperty list uchar int vertex_indices\nelement vertex 1\nproperty uchar red\nproperty float z\n"
                          "property float x\nproperty float y\nend_header\n3 0 1 2\n255 1 2 3\n")),
        TEXT(PLY("binary_little_endian", "element vertex 2\nproperty char x\nproperty short y\nproperty uint z\nend_header\n"
                                         "\x01\x02\x00\x03\x00\x00\x00\xff\xff\xff\x03\x00\x00\x00")),
        TEXT(PLY("binary_big_endian", "element vertex 1\nproperty float32 x\nproperty float64 y\nproperty int16 z\nproperty list uint8 int8 l\nend_header\n"
                                      "\x3f\x80\x00\x00\x40\x00\x00\x00\x00\x00\x00\x00\x00\x05\x02\x07\x08")), { NULL, 0 } };

    return read_raw(g, ".ply", some);
}

verdict prop_cloud_read_raw_obj(gen *g)
{
    static const sample some[] = {
        TEXT("# o\nv 1 2 3\nv 4 5 6 1.0\nvn 0 0 1\nvt 0 0\nf 1//1 2//1 1//1\n"), TEXT("v 1 2 \\\n3\nv 4 5 6 0.1 0.2 0.3\nl 1 2 \\\n1\n"),
        TEXT("mtllib a.mtl\no a\ng b\nv\t-1.5e-3\t.5\t2.\r\ns off\r\n"), { NULL, 0 } };

    return read_raw(g, ".obj", some);
}

#define ZERO4 "\0\0\0\0"
#define ZERO16 ZERO4 ZERO4 ZERO4 ZERO4

verdict prop_cloud_read_raw_stl(gen *g)
{
    static const sample some[] = {
        TEXT("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n"),
        TEXT("solid\n facet normal 0 0 0\n  outer loop\n   vertex 1e3 -1E-3 0\n   vertex 1e3 -1E-3 -0\n   vertex 2 2 2\n  endloop\n endfacet\nendsolid\n"
             "solid b\nvertex 1 2 3\nendsolid b\n"),
        TEXT("binary header  |" ZERO16 ZERO16 ZERO16 ZERO16 "\x01\0\0\0" ZERO4 ZERO4 "\0\0\x80\x3f" ZERO4 ZERO4 ZERO4 "\0\0\x80\x3f" ZERO4 ZERO4 ZERO4
             "\0\0\x80\x3f" ZERO4 "\0\0"), { NULL, 0 } };

    return read_raw(g, ".stl", some);
}

verdict prop_cloud_read_raw_pcd(gen *g)
{
    static const sample some[] = {
        TEXT("# .PCD v.7 - Point Cloud Data file format\nVERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2\nHEIGHT 1\n"
             "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA ascii\n1 2 3\n4 5 6\n"),
        TEXT("VERSION 0.7\nFIELDS rgb z y x n\nSIZE 4 4 4 4 4\nTYPE U F F F F\nCOUNT 1 1 1 1 3\nWIDTH 1\nHEIGHT 2\nDATA ascii\n7 3 2 1 0 0 1\n8 6 5 4 0 1 0\n"),
        { NULL, 0 } };

    return read_raw(g, ".pcd", some);
}
