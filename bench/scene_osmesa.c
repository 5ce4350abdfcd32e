/* OSMesa, OpenGL on the CPU: llvmpipe without threads of its own. A mesh in
 * buffers of the context, its light by the fixed pipeline, or for Phong by a
 * shader. */
#define _POSIX_C_SOURCE 200809L
#define GL_GLEXT_PROTOTYPES
#include "scene_osmesa.h"

#include <math.h>
#include <stdlib.h>

#include <GL/osmesa.h>

#include "core/scene/select.h"
#include "method.h"

struct vertex {
    float position[3], normal[3];
    GLubyte color[4];
};

struct scene_osmesa {
    OSMesaContext context;
    uint32_t *pixels;
    GLsizei indices;
};

static struct vertex vertex_of(const struct pel_mesh *m, uint32_t i)
{
    struct vertex v = {.color = {255, 255, 255, 255}};
    for (int k = 0; k < 3; k++) {
        v.position[k] = (float)ldexp(
            (double)pel_quantization_value(&m->position, k, m->positions[i][k]),
            -m->position.shift);
        v.normal[k] = (float)m->normals8[i][k] / 127;
        v.color[k] = m->colors[i][k];
    }
    return v;
}

static void load_mesh(struct scene_osmesa *o, const struct pel_mesh *m)
{
    const GLsizei size = sizeof(struct vertex);
    struct vertex *vertex = method_allocate((int)m->vertices, sizeof *vertex);
    GLuint buffer[2];
    for (uint32_t i = 0; i < m->vertices; i++)
        vertex[i] = vertex_of(m, i);
    glGenBuffers(2, buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer[0]);
    glBufferData(GL_ARRAY_BUFFER, size * (GLsizeiptr)m->vertices, vertex,
                 GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, 12 * (GLsizeiptr)m->triangles,
                 m->indices32, GL_STATIC_DRAW);
    o->indices = (GLsizei)m->triangles * 3;
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glVertexPointer(3, GL_FLOAT, size, NULL);
    glNormalPointer(GL_FLOAT, size, (void *)offsetof(struct vertex, normal));
    glColorPointer(4, GL_UNSIGNED_BYTE, size,
                   (void *)offsetof(struct vertex, color));
    free(vertex);
}

/* The camera looks at (0, 0, 0); y is up. */
static void set_camera(const struct pel_camera *c, double far)
{
    const double near = c->near_plane / 65536.;
    const double x = near * c->sensor[0] / c->focal / 2;
    const double y = near * c->sensor[1] / c->focal / 2;
    double eye[3], length = 0, flat;
    for (int k = 0; k < 3; k++) {
        eye[k] = c->eye[k] / 65536.;
        length += eye[k] * eye[k];
    }
    length = sqrt(length);
    flat = hypot(eye[0], eye[2]);
    glMatrixMode(GL_PROJECTION);
    glFrustum(-x, x, y, -y, near,
              length + far); /* Pel's first row is the top */
    glMatrixMode(GL_MODELVIEW);
    glTranslated(0, 0, -length);
    glRotated(atan2(eye[1], flat) * 45 / atan(1), 1, 0, 0);
    glRotated(-atan2(eye[0], eye[2]) * 45 / atan(1), 0, 1, 0);
}

static void set_light(const struct pel_lighting *l)
{
    const struct pel_light *light = &l->light[0];
    GLfloat at[4] = {0, 0, 0, !light->directional};
    GLfloat ambient[4], diffuse[4], specular[4];
    for (int k = 0; k < 3; k++) {
        at[k] = (GLfloat)light->at[k] / 65536;
        ambient[k] = (GLfloat)l->ambient / 65536;
        diffuse[k] = (GLfloat)l->diffuse / 65536;
        specular[k] = (GLfloat)l->specular / 65536;
    }
    ambient[3] = diffuse[3] = specular[3] = 1;
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, (GLfloat[4]){0});
    glLightfv(GL_LIGHT0, GL_POSITION, at);
    glLightfv(GL_LIGHT0, GL_AMBIENT, ambient);
    glLightfv(GL_LIGHT0, GL_DIFFUSE, diffuse);
    glLightfv(GL_LIGHT0, GL_SPECULAR, specular);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, (GLfloat[4]){1, 1, 1, 1});
    glMateriali(GL_FRONT_AND_BACK, GL_SHININESS, l->shininess);
}

/* Light at every pixel, as in core/scene/light.h. */
static const char vertex_shader[] = "varying vec3 at, n;\n"
                                    "void main() {\n"
                                    "    at = gl_Vertex.xyz;\n"
                                    "    n = gl_Normal;\n"
                                    "    gl_FrontColor = gl_Color;\n"
                                    "    gl_Position = ftransform();\n"
                                    "}\n";
static const char pixel_shader[] =
    "varying vec3 at, n;\n"
    "uniform vec3 eye, light;\n"
    "uniform vec4 terms;\n" /* ambient, diffuse, specular, shininess */
    "void main() {\n"
    "    vec3 N = normalize(n), V = normalize(eye - at);\n"
    "    vec3 L = normalize(light - at);\n"
    "    float nl = dot(N, L), rv = dot(2.0 * nl * N - L, V);\n"
    "    float sum = terms.x + terms.y * max(nl, 0.0) +\n"
    "                terms.z * pow(max(rv, 0.0), terms.w);\n"
    "    gl_FragColor = vec4(gl_Color.rgb * sum, 1.0);\n"
    "}\n";

static void add_shader(GLuint program, GLenum kind, const char *text)
{
    const GLuint shader = glCreateShader(kind);
    GLint ok;
    glShaderSource(shader, 1, &text, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (!ok)
        method_fail("OSMesa refuses a shader", "check its installation");
    glAttachShader(program, shader);
}

static void set_place(GLuint program, const char *name, const pel_length at[3])
{
    glUniform3f(glGetUniformLocation(program, name), (GLfloat)at[0] / 65536,
                (GLfloat)at[1] / 65536, (GLfloat)at[2] / 65536);
}

static void set_phong(const struct pel_scene *scene)
{
    const struct pel_lighting *l = scene->lighting;
    const GLuint program = glCreateProgram();
    add_shader(program, GL_VERTEX_SHADER, vertex_shader);
    add_shader(program, GL_FRAGMENT_SHADER, pixel_shader);
    glLinkProgram(program);
    glUseProgram(program);
    set_place(program, "eye", scene->camera.eye);
    set_place(program, "light", l->light[0].at);
    glUniform4f(glGetUniformLocation(program, "terms"),
                (GLfloat)l->ambient / 65536, (GLfloat)l->diffuse / 65536,
                (GLfloat)l->specular / 65536, (GLfloat)l->shininess);
}

void *scene_osmesa_open(const struct pel_scene *scene)
{
    struct scene_osmesa *o = method_allocate(1, sizeof *o);
    const int width = scene->viewport.x1, height = scene->viewport.y1;
    setenv("GALLIUM_DRIVER", "llvmpipe", 1);
    setenv("LP_NUM_THREADS", "0", 1);
    o->pixels = method_allocate(width * height, 4);
    o->context = OSMesaCreateContextExt(OSMESA_BGRA, 32, 0, 0, NULL);
    if (!o->context || !OSMesaMakeCurrent(o->context, o->pixels,
                                          GL_UNSIGNED_BYTE, width, height))
        method_fail("OSMesa refuses the picture", "check its installation");
    glViewport(0, 0, width, height);
    glDisable(GL_DITHER);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glFrontFace(GL_CW); /* y leads down */
    glShadeModel(scene->shading == &pel_shade_lit_flat ? GL_FLAT : GL_SMOOTH);
    set_camera(&scene->camera, 2);
    set_light(scene->lighting);
    if (scene->shading == &pel_shade_phong ||
        scene->shading == &pel_shade_chosen)
        set_phong(scene);
    load_mesh(o, scene->mesh);
    return o;
}

void scene_osmesa_draw(void *peer)
{
    const struct scene_osmesa *o = peer;
    glClear(GL_DEPTH_BUFFER_BIT);
    glDrawElements(GL_TRIANGLES, o->indices, GL_UNSIGNED_INT, NULL);
    glFinish();
}

const uint32_t *scene_osmesa_pixels(const void *peer)
{
    return ((const struct scene_osmesa *)peer)->pixels;
}

void scene_osmesa_close(void *peer)
{
    struct scene_osmesa *o = peer;
    OSMesaDestroyContext(o->context);
    free(o->pixels);
    free(o);
}
