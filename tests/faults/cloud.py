"""cloud.py FORMAT POINTS.xyz: the points as text with a long line, a binary PLY with a face, an ASCII PLY (ply-ascii), a binary STL, an OBJ or a PCD on standard output."""
import struct
import sys

TAGS = 300000                           # more than one read brings
points = [tuple(map(float, line.split()[:3])) for line in open(sys.argv[2])]
out, n = sys.stdout.buffer, len(points)
corners = "".join("%.9g %.9g %.9g\n" % p for p in points).encode()
if sys.argv[1] == "xyz":
    out.write(corners + b"# " + 3000000 * b"long " + b"\n")
elif sys.argv[1] == "ply":
    out.write(b"ply\nformat binary_little_endian 1.0\nelement tag %d\nproperty list uchar int of\nproperty short more\nelement vertex %d\n" % (TAGS, n))
    out.write(b"property float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n")
    out.write(TAGS * struct.pack("<B2ih", 2, 5, 6, 7) + b"".join(struct.pack("<3f", *p) for p in points) + struct.pack("<B3i", 3, 0, 1, 2))
elif sys.argv[1] == "ply-ascii":
    out.write(b"ply\nformat ascii 1.0\nelement tag %d\nproperty list uchar int of\nelement vertex %d\n" % (TAGS, n))
    out.write(b"property float x\nproperty float y\nproperty float z\nend_header\n" + TAGS * b"2 5 6\n" + corners)
elif sys.argv[1] == "stl":
    triangles = [points[k:k + 3] for k in range(0, n - 2, 3)] * 400
    out.write(b" " * 80 + struct.pack("<I", len(triangles)))
    out.write(b"".join(struct.pack("<3f", 0, 0, 1) + b"".join(struct.pack("<3f", *p) for p in t) + b"\0\0" for t in triangles))
elif sys.argv[1] == "obj":
    out.write(b"".join(b"v " + line for line in corners.splitlines(True)) + b"f 1 2 3\n")
else:
    out.write(b"VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH %d\nHEIGHT 1\nPOINTS %d\nDATA ascii\n" % (n, n) + corners)
