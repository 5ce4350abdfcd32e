/* Gouraud instead of Phong: light at the vertices and linear between, against
 * light for the normal of every pixel, in steps of 255. */
#include <math.h>
#include <stdio.h>

#include "cases.h"

/* Half diffuse, half specular; light and eye are far away. */
static const double diffuse = .5, specular = .5;

struct vector {
    double x, y, z;
};

static double dot(struct vector a, struct vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static struct vector scaled(struct vector v, double by)
{
    const struct vector s = {v.x * by, v.y * by, v.z * by};
    return s;
}

static struct vector sum(struct vector a, struct vector b)
{
    const struct vector s = {a.x + b.x, a.y + b.y, a.z + b.z};
    return s;
}

static struct vector unit(struct vector v)
{
    return scaled(v, 1 / sqrt(dot(v, v)));
}

/* The highlight is the power of R.V, as core has it, or of N.H. */
enum model { REFLECTED, HALFWAY };

struct setting {
    enum model model;
    int n;                    /* the exponent */
    struct vector light, eye; /* directions to them */
};

static double light_at(const struct setting *s, struct vector normal)
{
    const double nl = dot(normal, s->light);
    const struct vector reflected =
        sum(scaled(normal, 2 * nl), scaled(s->light, -1));
    const struct vector halfway = unit(sum(s->light, s->eye));
    const double cosine =
        s->model == REFLECTED ? dot(reflected, s->eye) : dot(normal, halfway);
    return diffuse * fmax(nl, 0) + specular * pow(fmax(cosine, 0), s->n);
}

/* A direction at the point (x, y) of the map around +z that keeps distances
 * from the middle. */
static struct vector direction(double x, double y)
{
    const double angle = sqrt(x * x + y * y);
    const double by = angle > 0 ? sin(angle) / angle : 1;
    const struct vector v = {x * by, y * by, cos(angle)};
    return v;
}

static double any(struct random *r, double low, double high)
{
    return low + (high - low) * random_between(r, 0, 1 << 20) / (1 << 20);
}

/* Three normals, the largest angle between two of them about theta, near the
 * middle of the highlight. */
static void any_normals(struct random *r, double theta, double around,
                        struct vector normal[3])
{
    const double x = any(r, -around, around), y = any(r, -around, around);
    const double turn = any(r, 0, 6.2831853), third = any(r, -.5, .5);
    const double off = any(r, 0, .86) * theta;
    const double c = cos(turn), s = sin(turn);
    normal[0] = direction(x - c * theta / 2, y - s * theta / 2);
    normal[1] = direction(x + c * theta / 2, y + s * theta / 2);
    normal[2] = direction(x + c * third * .2 * theta - s * off,
                          y + s * third * .2 * theta + c * off);
}

/* Over weights in sixteenths. */
static double error_of(const struct setting *s, const struct vector normal[3])
{
    enum { PARTS = 16 };
    const double at[3] = {light_at(s, normal[0]), light_at(s, normal[1]),
                          light_at(s, normal[2])};
    double worst = 0;
    for (int i = 0; i <= PARTS; i++)
        for (int k = 0; i + k <= PARTS; k++) {
            const double u = i / (double)PARTS, v = k / (double)PARTS;
            const double w = 1 - u - v;
            const struct vector normal_here =
                unit(sum(sum(scaled(normal[0], u), scaled(normal[1], v)),
                         scaled(normal[2], w)));
            const double linear = u * at[0] + v * at[1] + w * at[2];
            worst = fmax(worst, fabs(light_at(s, normal_here) - linear));
        }
    return 255 * worst;
}

/* kd a b / (a + b) where N.L changes its sign, from a to -b. */
static double kink(const struct setting *s, const struct vector normal[3])
{
    double low = 1, high = -1;
    for (int i = 0; i < 3; i++) {
        const double nl = dot(normal[i], s->light);
        low = fmin(low, nl);
        high = fmax(high, nl);
    }
    return low < 0 && high > 0 ? diffuse * high * -low / (high - low) : 0;
}

/* (ks n + kd) theta^2 / 5 and the kink. R turns by twice the angle of N: its
 * square is four times as large. */
static double bound_of(const struct setting *s, const struct vector normal[3])
{
    double cosine = 1;
    for (int i = 0; i < 3; i++)
        cosine = fmin(cosine, dot(normal[i], normal[(i + 1) % 3]));
    const double square = 2 * (1 - cosine);
    const double turns = s->model == REFLECTED ? 4 : 1;
    return 255 *
           ((specular * s->n * turns + diffuse) * square / 5 + kink(s, normal));
}

/* The bound is declared up to so many degrees. */
enum { DECLARED = 35 };

static void put_error(struct atlas *a, double degrees, enum model model, int n,
                      bool is_map)
{
    char name[32];
    struct random r = atlas_random(a, (uint32_t)(degrees * 1024) + (uint32_t)n);
    const double theta = degrees * 3.14159265358979 / 180;
    double worst = 0, bound = 0, excess = 0;
    for (int k = atlas_samples(a, 8000, 1000); k > 0; k--) {
        struct setting s = {
            model, n, direction(any(&r, -1.4, 1.4), 0), {0, 0, 0}};
        struct vector normal[3];
        s.eye = (struct vector){-s.light.x, -s.light.y, s.light.z};
        any_normals(&r, theta, 2 / sqrt(n) + theta, normal);
        const double error = error_of(&s, normal);
        const double most = bound_of(&s, normal);
        worst = fmax(worst, error);
        bound = fmax(bound, most);
        excess = fmax(excess, error - most);
    }
    snprintf(name, sizeof name, "%s n=%d", model == REFLECTED ? "R.V" : "N.H",
             n);
    struct figure f = figure_of(name, degrees, "error_max", worst, "step");
    if (is_map) {
        f.method = model == REFLECTED ? "R.V" : "N.H";
        f.y = n;
        f.has_y = true;
    }
    atlas_promise(a, excess <= 1e-6 || degrees > DECLARED, &f);
    atlas_put(a, f);
    f.metric = "bound";
    f.value = bound;
    atlas_put(a, f);
}

static const double angles[] = {1, 2, 3, 5, 7, 10, 15, 20, 25, 30, 35, 45, 60};
static const int exponents[] = {2, 4, 8, 16, 32, 64, 128, 256};

static void put_all(struct atlas *a, bool is_map)
{
    for (int model = REFLECTED; model <= HALFWAY; model++)
        for (size_t k = 0; k < sizeof exponents / sizeof *exponents; k++)
            for (size_t i = 0; i < sizeof angles / sizeof *angles; i++)
                put_error(a, angles[i], (enum model)model, exponents[k],
                          is_map);
}

void atlas_phong(struct atlas *a)
{
    put_all(a, false);
}

void atlas_map_phong(struct atlas *a)
{
    put_all(a, true);
}
