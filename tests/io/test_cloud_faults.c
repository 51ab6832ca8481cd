/* io/cloud: faults of files, one by one. */
#include "io/clouds.h"

/* ---- faults, one by one ---- */

#define PLY_HEAD "ply\nformat ascii 1.0\n"
#define PLY_XYZ "property double x\nproperty double y\nproperty double z\nend_header\n"
#define PCD_HEAD "# .PCD v.7\nFIELDS x y z\n"

/* ending, text, what follows the file's name in the message; null: it is read, `points` points. */
static const struct { const char *ending, *text, *message; size_t points; } faults[] = {
    { ".xyz", "", ": no points", 0 },
    { ".xyz", "\n\n# only\n", ": no points", 0 },
    { ".xyz", "x y z\n", ": no points", 0 },
    { ".xyz", "0\n", ": no points", 0 },
    { ".xyz", "1 2 3", NULL, 1 },
    { ".xyz", "1 2", ":1: z is missing", 0 },
    { ".xyz", "1", ":1: the count is 1, but 0 points follow", 0 },
    { ".xyz", "\n-1", ":2: y is missing", 0 },
    { ".xyz", "1 2 3\n4 5\n6 7 8\n", ":2: z is missing", 0 },
    { ".xyz", "1 2 3\r\n4 5\r\n6 7 8\r\n", ":2: z is missing", 0 },
    { ".xyz", "1 2 3\r\r4\r", ":3: y is missing", 0 },
    { ".xyz", "1 2 3\n\n7\n", ":3: y is missing", 0 },
    { ".xyz", "1 2 3\nabc 5 6\n", ":2: x is not a number: \"abc\"", 0 },
    { ".xyz", "abc 5 6\n", ":1: x is not a number: \"abc\"", 0 },
    { ".xyz", "a b c\nd e f\n", ":2: x is not a number: \"d\"", 0 },
    { ".xyz", "nan nan nan\n", ":1: x is not finite", 0 },
    { ".xyz", "1 NaN 3\n", ":1: y is not finite", 0 },
    { ".xyz", "1 2 inf\n", ":1: z is not finite", 0 },
    { ".xyz", "1 2 -Infinity\n", ":1: z is not finite", 0 },
    { ".xyz", "1 2 nan(7)\n", ":1: z is not finite", 0 },
    { ".xyz", "1 2 1e999\n", ":1: z is not finite", 0 },
    { ".xyz", "1 2 1e99999999999999999999\n", ":1: z is not finite", 0 },
    { ".xyz", "1 2 0x1p9999\n", ":1: z is not finite", 0 },
    { ".xyz", "1 2 1e-99999999999999999999\n", NULL, 1 },
    { ".xyz", "1.0.0 2 3\n", ":1: x is not a number: \"1.0.0\"", 0 },
    { ".xyz", "1e 2 3\n", ":1: x is not a number: \"1e\"", 0 },
    { ".xyz", "1e+ 2 3\n", ":1: x is not a number: \"1e+\"", 0 },
    { ".xyz", "1 2 .\n", ":1: z is not a number: \".\"", 0 },
    { ".xyz", "1 2 -\n", ":1: z is not a number: \"-\"", 0 },
    { ".xyz", "1 2 +-3\n", ":1: z is not a number: \"+-3\"", 0 },
    { ".xyz", "1 2 3x\n", ":1: z is not a number: \"3x\"", 0 },
    { ".xyz", "1 2 0x\n", ":1: z is not a number: \"0x\"", 0 },
    { ".xyz", "1 2 infx\n", ":1: z is not a number: \"infx\"", 0 },
    { ".xyz", "1 2 3e5 x\n", NULL, 1 },
    { ".xyz", "1 2 3\001\n", ":1: z is not a number: \"3?\"", 0 },
    { ".xyz", "1 2 aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa\n",
      ":1: z is not a number: \"aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa...\"", 0 },
    { ".xyz", "1,5;2,5;3,5\n", ":1: y is not a number: \"5;2\" (mixed separators, or a decimal comma)", 0 },
    { ".xyz", "1,5 2,5 3,5\n", ":1: y is not a number: \"5 2\" (mixed separators, or a decimal comma)", 0 },
    { ".xyz", "1\t2,5\t3\n", ":1: y is not a number: \"2,5\" (mixed separators, or a decimal comma)", 0 },
    { ".xyz", "1;2;3,5\n", ":1: z is not a number: \"3,5\" (mixed separators, or a decimal comma)", 0 },
    { ".xyz", "1 2 3 a,b\nx 2 3\n", ":2: x is not a number: \"x\"", 0 },
    { ".xyz", "2 b;c 4\n", ":1: y is not a number: \"b;c\" (mixed separators, or a decimal comma)", 0 },
    { ".xyz", "a b,;\tc 3\n", ":1: x is not a number: \"a\"", 0 },
    { ".xyz", "\"left x\", y, x, z\nq, 1, 2, 3\n", NULL, 1 },
    { ".xyz", "1,,3\n", ":1: y is missing", 0 },
    { ".xyz", ",1,2\n", ":1: x is missing", 0 },
    { ".xyz", "1,2,\n", ":1: z is missing", 0 },
    { ".xyz", "1,2,3,\n", NULL, 1 },
    { ".xyz", "2\n1 2 3\n4 5 6\n", NULL, 2 },
    { ".xyz", "# c\n2\nx y z\n1 2 3\n4 5 6\n", NULL, 2 },
    { ".xyz", "# c\n3\n1 2 3\n4 5 6\n", ":2: the count is 3, but 2 points follow", 0 },
    { ".xyz", "1\n1 2 3\n4 5 6\n", ":1: the count is 1, but 2 points follow", 0 },
    { ".xyz", "2\n2\n1 2 3\n", ":2: y is missing", 0 },
    { ".xyz", "99999999999999999999999\n1 2 3\n", ":1: y is missing", 0 },
    { ".xyz", "x,y,h\n1,2,3\n", ":1: the header names z not at all, but another of x, y, z", 0 },
    { ".xyz", "x,y,z,x\n1,2,3,4\n", ":1: the header names x twice", 0 },
    { ".xyz", "a,b,x,y,z\n1,2,3,4\n", ":2: z is missing", 0 },
    { ".xyz", "name;x;y;z\nJohn Smith;1;2;3\n", NULL, 1 },
    { ".xyz", "x,y,z\n1 2 3\n4,5,6\n", NULL, 2 },
    { ".xyz", "1 2 3 // 4\n4 5 6 #\n7/8 9 9\n", ":3: x is not a number: \"7/8\"", 0 },
    { ".xyz", "solve 1 2\n", ":1: x is not a number: \"solve\"", 0 },
    { ".obj", "v 1 2 3\nv 1 2\n", ":2: z is missing", 0 },
    { ".obj", "v 1 2 \\\n\nv 1 2 3\n", ":1: z is missing", 0 },
    { ".obj", "v 1 \\\n 2 3\n\nv 1 x 3\n", ":4: y is not a number: \"x\"", 0 },
    { ".obj", "v 1 2 # 3\n", ":1: z is missing", 0 },
    { ".obj", "v 1 2 nan\n", ":1: z is not finite", 0 },
    { ".obj", "v 1,2,3\n", ":1: x is not a number: \"1,2,3\" (mixed separators, or a decimal comma)", 0 },
    { ".obj", "f 1 2 3\n", ": no points", 0 },
    { ".obj", "v 1 2 3\\", NULL, 1 },
    { ".ply", "ply", ":2: the file ends within the PLY header", 0 },
    { ".ply", "ply\nformat ascii 1.0\n", ":3: the file ends within the PLY header", 0 },
    { ".ply", "ply\nformat ascii 2.0\n", ":2: unknown PLY version \"2.0\"", 0 },
    { ".ply", "ply\nformat ascii\n", ":2: unknown PLY version \"\"", 0 },
    { ".ply", "ply\nformat text 1.0\n", ":2: unknown PLY format \"text\"", 0 },
    { ".ply", "ply\nelement vertex 1\n" PLY_XYZ "1 2 3\n", ":6: PLY header without a format", 0 },
    { ".ply", "ply\nelement vertex\n", ":2: \"\" is not a count", 0 },
    { ".ply", "ply\nelement vertex -5\n", ":2: \"-5\" is not a count", 0 },
    { ".ply", "ply\nelement vertex 18446744073709551616\n", ":2: \"18446744073709551616\" is not a count", 0 },
    { ".ply", "ply\nelement vertex 1e3\n", ":2: \"1e3\" is not a count", 0 },
    { ".ply", "ply\nproperty float x\n", ":2: property before any element", 0 },
    { ".ply", "ply\nelement vertex 1\nproperty half x\n", ":3: unknown PLY type \"half\"", 0 },
    { ".ply", "ply\nelement vertex 1\nproperty float\n", ":3: property without a name", 0 },
    { ".ply", "ply\nelement vertex 1\nproperty list float int x\n", ":3: unknown PLY list length type \"float\"", 0 },
    { ".ply", "ply\nelement vertex 1\nproperty float x\nproperty int x\n", ":4: property x twice", 0 },
    { ".ply", "ply\nelements vertex 1\n", ":2: unknown PLY keyword \"elements\"", 0 },
    { ".ply", PLY_HEAD "element vertex 1\nproperty float x\nproperty float y\nend_header\n1 2\n",
      ":6: a vertex has not all of the properties x, y, z", 0 },
    { ".ply", PLY_HEAD "element vertex 1\nproperty float x\nproperty float y\nproperty list char float z\nend_header\n1 2 1 3\n",
      ":7: a vertex has not all of the properties x, y, z", 0 },
    { ".ply", PLY_HEAD "element face 1\n" PLY_XYZ, ":7: PLY header with 0 elements vertex", 0 },
    { ".ply", PLY_HEAD "element vertex 1\nelement vertex 1\n" PLY_XYZ, ":8: PLY header with 2 elements vertex", 0 },
    { ".ply", PLY_HEAD "element vertex 0\n" PLY_XYZ, ": no points", 0 },
    { ".ply", PLY_HEAD "element vertex 2\n" PLY_XYZ "1 2 3\n", ":9: vertex 2 of 2 is missing (truncated)", 0 },
    { ".ply", PLY_HEAD "element vertex 1000000000000000000\n" PLY_XYZ "1 2 3\n4 5 6\n",
      ":10: vertex 3 of 1000000000000000000 is missing (truncated)", 0 },
    { ".ply", PLY_HEAD "element vertex 1\n" PLY_XYZ "1 2\n", ":8: z is missing", 0 },
    { ".ply", PLY_HEAD "element vertex 1\n" PLY_XYZ "1 2 3 4\n", ":8: more values than properties", 0 },
    { ".ply", PLY_HEAD "element vertex 1\n" PLY_XYZ "1 x 3\n", ":8: y is not a number: \"x\"", 0 },
    { ".ply", PLY_HEAD "element vertex 1\n" PLY_XYZ "1 2 nan\n", ":8: z is not finite", 0 },
    { ".ply", PLY_HEAD "element vertex 1\nproperty int a\n" PLY_XYZ "7 1 2 3\n", NULL, 1 },
    { ".ply", PLY_HEAD "element face 1\nproperty list uchar int i\nelement vertex 1\n" PLY_XYZ "3 0 1\n1 2 3\n",
      ":10: fewer values than properties", 0 },
    { ".ply", PLY_HEAD "element face 1\nproperty list uchar int i\nelement vertex 1\n" PLY_XYZ "-1 0 1\n1 2 3\n",
      ":10: a list's length is not a count", 0 },
    { ".ply", PLY_HEAD "element face 1\nproperty list uchar int i\nelement vertex 1\n" PLY_XYZ "2 0 1 5\n1 2 3\n",
      ":10: more values than properties", 0 },
    { ".ply", PLY_HEAD "element face 3\nproperty list uchar int i\nelement vertex 1\n" PLY_XYZ "1 0\n1 2\n",
      ":12: face 3 of 3 is missing (truncated)", 0 },
    { ".ply", "ply\nformat binary_little_endian 1.0\nelement vertex 3\n" PLY_XYZ "aaaaaaaabbbbbbbbccccccccaaaaaaaabbbbbbbb",
      ": vertex 2 of 3 is missing (truncated)", 0 },
    { ".ply", "ply\nformat binary_big_endian 1.0\nelement vertex 18446744073709551615\n" PLY_XYZ "aaaaaaaabbbbbbbbcccccccc",
      ": vertex 2 of 18446744073709551615 is missing (truncated)", 0 },
    { ".ply", "ply\nformat binary_big_endian 1.0\nelement vertex 1\n" PLY_XYZ "aaaaaaaa\x7f\xf8zzzzzzcccccccc", ": vertex 1: y is not finite", 0 },
    { ".ply", "ply\nformat binary_big_endian 1.0\nelement face 2\nproperty list int char i\nelement vertex 1\n" PLY_XYZ "\xff\xff\xff\xff",
      ": face 1 has a list of negative length", 0 },
    { ".ply", "ply\nformat binary_big_endian 1.0\nelement face 2\nproperty list uint double i\nelement vertex 1\n" PLY_XYZ "\xff\xff\xff\xff....",
      ": face 1 of 2 is missing (truncated)", 0 },
    { ".ply", "plyx 1 2\n", ":1: x is not a number: \"plyx\"", 0 },
    { ".stl", "solid a\nvertex 1 2 3\nvertex 1 2 3.0\n vertex 4 5 6\nendsolid\n", NULL, 2 },
    { ".stl", "solid a\nvertex 1 2 3\nendsolid\nsolid b\nvertex 4 5 6\nendsolid b\n", NULL, 2 },
    { ".stl", "solid a\nvertex 1 2 3\n", ":3: the file ends without endsolid (truncated)", 0 },
    { ".stl", "solid a\nvertex 1 2\nendsolid\n", ":2: z is missing", 0 },
    { ".stl", "solid a\nvertex 1 2 z\nendsolid\n", ":2: z is not a number: \"z\"", 0 },
    { ".stl", "solid a\nvertices 1 2 3\nendsolid\n", ":2: unknown STL keyword \"vertices\"", 0 },
    { ".stl", "solid a\nfacet normal 0 0 1 2\nendsolid\n", ":2: unknown STL keyword \"2\"", 0 },
    { ".stl", "solid a\nvertex 1 2 inf\nendsolid\n", ":2: z is not finite", 0 },
    { ".stl", "solid a\nendsolid\n", ": no points", 0 },
    { ".stl", "something else\n", ": STL header is not complete", 0 },
    { ".pcd", "nothing\n", ":1: unknown PCD keyword \"nothing\"", 0 },
    { ".pcd", PCD_HEAD, ":3: the file ends within the PCD header", 0 },
    { ".pcd", PCD_HEAD "DATA binary\n", ":3: of PCD only DATA ascii is read", 0 },
    { ".pcd", PCD_HEAD "DATA binary_compressed\n", ":3: of PCD only DATA ascii is read", 0 },
    { ".pcd", PCD_HEAD "DATA text\n", ":3: unknown PCD data \"text\"", 0 },
    { ".pcd", PCD_HEAD "DATA ascii\n", ":3: PCD header without POINTS", 0 },
    { ".pcd", PCD_HEAD "WIDTH 4\nDATA ascii\n", ":4: PCD header without POINTS", 0 },
    { ".pcd", "VERSION .7\nPOINTS 1\nDATA ascii\n", ":3: PCD header without FIELDS", 0 },
    { ".pcd", "FIELDS x y\n", ":1: FIELDS names z not at all", 0 },
    { ".pcd", "FIELDS x y z y\n", ":1: FIELDS names y twice", 0 },
    { ".pcd", PCD_HEAD "COUNT 1 1\n", ":3: 2 COUNT for 3 FIELDS", 0 },
    { ".pcd", PCD_HEAD "COUNT 1 2 1\n", ":3: COUNT of y is not 1", 0 },
    { ".pcd", PCD_HEAD "COUNT 1 1 x\n", ":3: unknown COUNT \"x\"", 0 },
    { ".pcd", PCD_HEAD "POINTS -1\n", ":3: unknown count \"-1\"", 0 },
    { ".pcd", PCD_HEAD "WIDTH 2\nHEIGHT 3\nPOINTS 5\nDATA ascii\n", ":6: WIDTH times HEIGHT is 6, POINTS 5", 0 },
    { ".pcd", PCD_HEAD "WIDTH 4294967296\nHEIGHT 4294967296\nDATA ascii\n", ":5: WIDTH times HEIGHT is too large", 0 },
    { ".pcd", PCD_HEAD "POINTS 2\nDATA ascii\n1 2 3\n", ":6: the file ends after 1 of 2 points", 0 },
    { ".pcd", PCD_HEAD "POINTS 1\nDATA ascii\n1 2 3\n4 5 6\n", ":6: more than the declared 1 points", 0 },
    { ".pcd", PCD_HEAD "POINTS 1\nDATA ascii\n1 2 nan\n", ":5: z is not finite", 0 },
    { ".pcd", PCD_HEAD "POINTS 1\nDATA ascii\n1 2\n", ":5: z is missing", 0 },
    { ".pcd", PCD_HEAD "POINTS 1\nDATA ascii\n1 2 3 4\n", ":5: 4 columns, 3 declared", 0 },
    { ".pcd", PCD_HEAD "POINTS 0\nDATA ascii\n", ": no points", 0 },
};

static bool fault_is_told(gen *g, size_t k)
{
    text t = { .end_of_line = "\n" };
    char path[PATH], wanted[2 * PATH];
    et_cloud cloud;
    et_message message;
    bool ok;

    put_bytes(&t, faults[k].text, strlen(faults[k].text));
    spill(some_path(path, faults[k].ending), &t);
    const et_status status = read_checked(g, &cloud, path, &message, &ok);
    if (faults[k].message) {
        snprintf(wanted, sizeof wanted, "%s%s", path, faults[k].message);
        ok = ok && gen_check(g, status == ET_EFORMAT && strcmp(message.text, wanted) == 0, "fault %zu: \"%s\", not \"%s\"", k, message.text, wanted);
    } else {
        ok = ok && gen_check(g, status == ET_OK && cloud.count == faults[k].points, "fault %zu: %s", k, message.text);
    }
    et_cloud_free(&cloud);
    unlink(path);
    free(t.bytes);
    return ok;
}

verdict prop_cloud_read_faults(gen *g)
{
    const size_t n = sizeof faults / sizeof *faults, k = (size_t)gen_upto(g, n);
    bool ok = true;

    for (size_t i = 0; k == 0 && ok && i < n; i++)
        ok = fault_is_told(g, i);
    return ok && (k == 0 || fault_is_told(g, k - 1)) ? PASS : FAIL;
}

/* A NUL byte in a text, a binary STL that is short or has more, a point that is not finite in it. */
verdict prop_cloud_read_bytes(gen *g)
{
    static const char nul[] = "1 2 3\n4 \0005 6\n";
    text t = { .end_of_line = "\n" };
    const uint64_t kind = gen_upto(g, 3);
    const size_t n = 2 + (size_t)gen_upto(g, 5);
    char path[PATH], wanted[2 * PATH];
    et_cloud cloud;
    et_message message;
    bool ok;

    some_path(path, kind == 0 ? ".xyz" : ".stl");
    if (kind == 0) {
        put_bytes(&t, nul, sizeof nul - 1);
        snprintf(wanted, sizeof wanted, "%s:2: NUL byte in a text file", path);
    } else {
        put_stl_binary(g, &t, n);
        t.bytes[6] = 0;
        if (kind == 1) {                  /* short by a part of the last triangle at most */
            t.n -= 1 + (size_t)gen_upto(g, 49);
            snprintf(wanted, sizeof wanted, "%s: triangle %zu of %zu is missing (truncated)", path, n, n);
        } else if (kind == 2) {
            put_bytes(&t, "more", 1 + (size_t)gen_upto(g, 3));
            snprintf(wanted, sizeof wanted, "%s: more bytes than its %zu triangles", path, n);
        } else {
            const size_t at = (size_t)gen_upto(g, 8);
            memcpy(t.bytes + 84 + 50 * (n - 1) + 12 + 4 * at, "\x00\x00\x80\x7f", 4);
            snprintf(wanted, sizeof wanted, "%s: triangle %zu, vertex %zu: %c is not finite", path, n, at / 3 + 1, "xyz"[at % 3]);
        }
    }
    spill(path, &t);
    const et_status status = read_checked(g, &cloud, path, &message, &ok);
    ok = ok && gen_check(g, status == ET_EFORMAT && strcmp(message.text, wanted) == 0, "%s, not %s", message.text, wanted);
    et_cloud_free(&cloud);
    unlink(path);
    free(t.bytes);
    return ok ? PASS : FAIL;
}

/* Whatever the bytes are: a cloud of finite points, or a sentence with the file's name. */
verdict prop_cloud_read_mutated(gen *g)
{
    static const char *const endings[] = { ".xyz", ".obj", ".stl", ".pcd", ".ply" };
    const size_t k = (size_t)gen_upto(g, sizeof faults / sizeof *faults + 2);
    text t = { .end_of_line = "\n" };
    char path[PATH];
    et_cloud cloud;
    et_message message;
    bool ok;

    if (k < sizeof faults / sizeof *faults)
        put_bytes(&t, faults[k].text, strlen(faults[k].text));
    else if (k == sizeof faults / sizeof *faults)
        put_stl_binary(g, &t, 1 + (size_t)gen_upto(g, 3));
    for (uint64_t changes = gen_upto(g, 8); changes > 0; changes--) {
        char byte = (char)gen_upto(g, 255);
        const size_t at = (size_t)gen_upto(g, t.n);
        if (at == t.n || gen_chance(g, 4)) {
            put_bytes(&t, &byte, 1);
            memmove(t.bytes + at + 1, t.bytes + at, t.n - 1 - at);
        }
        t.bytes[at] = byte;
        if (gen_chance(g, 8))
            t.n = at;
    }
    spill(some_path(path, endings[gen_upto(g, 4)]), &t);
    gen_label(g, read_checked(g, &cloud, path, &message, &ok) ? "refused" : "read");
    et_cloud_free(&cloud);
    unlink(path);
    free(t.bytes);
    return ok ? PASS : FAIL;
}
