# A sphere of radius 1 as an OBJ file: 20 segments around the axis, 12 from pole to
# pole; the picture lies on it as a map of the world does, west at the left.
BEGIN {
    AROUND = 20
    DOWN = 12
    pi = atan2(0, -1)
    for (j = 0; j <= DOWN; j++)
        for (i = 0; i <= AROUND; i++) {
            along = (2 * i / AROUND - 1) * pi
            from = j / DOWN * pi
            x = sin(from) * sin(along)
            y = cos(from)
            z = sin(from) * cos(along)
            printf "v %.5f %.5f %.5f\nvt %.5f %.5f\nvn %.5f %.5f %.5f\n",
                x, y, z, i / AROUND, 1 - j / DOWN, x, y, z
        }
    for (j = 0; j < DOWN; j++)
        for (i = 0; i < AROUND; i++) {
            a = j * (AROUND + 1) + i + 1
            b = a + AROUND + 1
            if (j > 0)
                face(a, b, a + 1)
            if (j < DOWN - 1)
                face(a + 1, b, b + 1)
        }
}

function face(a, b, c)
{
    printf "f %d/%d/%d %d/%d/%d %d/%d/%d\n", a, a, a, b, b, b, c, c, c
}
