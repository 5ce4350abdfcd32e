/* Qt 5: a QPainter on a QImage, without antialiasing but for smooth shapes, one
 * brush for a shape. */
#include <cstdlib>

#include <QGlyphRun>
#include <QGuiApplication>
#include <QImage>
#include <QLinearGradient>
#include <QPainter>
#include <QPainterPath>
#include <QPolygon>
#include <QRawFont>

extern "C" {
#include "method.h"
}

struct item {
    QPoint point[SHAPE_VERTICES];
    QBrush brush;
};

struct job {
    const struct workload *workload;
    QImage *image;
    QImage sprite;
    QPainter *painter;
    struct item *item;
    QGlyphRun run;     /* of a line at (0, 0), */
    QPainterPath path; /* or its outlines */
};

static QBrush gradient_of(const struct workload *w, const struct shape *s)
{
    const QPointF center(w->width / 2., w->height / 2.);
    QLinearGradient linear(QPointF(0, 0), QPointF(s->x[2], s->y[2]));
    QRadialGradient radial(center, w->width / 2.);
    QConicalGradient conic(center, 0);
    const bool stops =
        w->paint == PAINT_RADIAL_STOPS || w->paint == PAINT_CONIC_STOPS;
    QGradient *g = &conic;
    if (w->paint < PAINT_RADIAL)
        g = &linear;
    else if (w->paint < PAINT_CONIC)
        g = &radial;
    g->setColorAt(0, QColor::fromRgb(s->color[0]));
    if (stops)
        g->setColorAt(.5, QColor::fromRgb(s->color[2]));
    g->setColorAt(1, QColor::fromRgb(s->color[1]));
    return QBrush(*g);
}

/* The turned texture at unit scale, its middle at vertex 0. */
static QBrush texture_of(const struct shape *s, const QImage &texture)
{
    const double dx = s->x[1] - s->x[0], dy = s->y[1] - s->y[0];
    const double du = s->u[1] - s->u[0], dv = s->v[1] - s->v[0];
    const double square = dx * dx + dy * dy;
    const double c = (dx * du + dy * dv) / square;
    const double t = (dx * dv - dy * du) / square;
    const QTransform to_texels(c, t, -t, c, s->u[0] - c * s->x[0] + t * s->y[0],
                               s->v[0] - t * s->x[0] - c * s->y[0]);
    QBrush brush(texture);
    brush.setTransform(to_texels.inverted());
    return brush;
}

static QBrush brush_of(const struct workload *w, const struct shape *s,
                       const QImage &texture)
{
    QColor color = QColor::fromRgb(s->color[0]);
    if (w->form == FORM_SCREEN && w->paint != PAINT_FLAT)
        return gradient_of(w, s);
    if (w->paint == PAINT_NEAREST || w->paint == PAINT_BILINEAR)
        return texture_of(s, texture);
    if (w->paint == PAINT_ALPHA)
        color.setAlpha(WORKLOAD_ALPHA);
    return QBrush(color);
}

static struct item item_of(const struct workload *w, const struct shape *s,
                           const QImage &texture)
{
    struct item item;
    for (int k = 0; k < SHAPE_VERTICES; k++)
        item.point[k] = QPoint(s->x[k], s->y[k]);
    item.brush = brush_of(w, s, texture);
    return item;
}

static void open_text(struct job *job)
{
    static char name[] = "bench", option[] = "-platform", value[] = "offscreen";
    static char *arguments[] = {name, option, value, nullptr};
    static int n = 3;
    if (!qGuiApp)
        new QGuiApplication(n, arguments);
    const struct workload_line line = workload_line(job->workload);
    const QRawFont font(QString(TEXT_FONT), line.em, QFont::PreferNoHinting);
    const QVector<quint32> glyphs = font.glyphIndexesForString(line.text);
    QVector<QPointF> places;
    for (int k = 0; k < line.letters; k++) {
        places.append(QPointF(k * line.advance, 0));
        job->path.addPath(font.pathForGlyph(glyphs[k]).translated(places[k]));
    }
    job->path.setFillRule(Qt::WindingFill);
    job->run.setRawFont(font);
    job->run.setGlyphIndexes(glyphs);
    job->run.setPositions(places);
}

static void *open_job(const struct workload *w, const struct canvas *c)
{
    if (w->paint == PAINT_GOURAUD || w->paint == PAINT_DITHERED ||
        w->paint == PAINT_FAN || w->paint == PAINT_KEYED ||
        w->paint == PAINT_HITS || w->form == FORM_TEXT)
        return nullptr;
    const bool alpha = w->paint == PAINT_COPY_ALPHA;
    struct job *job = new struct job;
    job->workload = w;
    job->image =
        new QImage(c->pixels, c->width, c->height, c->stride,
                   c->bits == 32 ? QImage::Format_RGB32 : QImage::Format_RGB16);
    job->painter = new QPainter;
    if (!job->painter->begin(job->image))
        method_fail("Qt 5 refuses the canvas", "check its installation");
    job->painter->setPen(Qt::NoPen);
    job->painter->setRenderHint(QPainter::Antialiasing,
                                w->paint == PAINT_SMOOTH);
    job->painter->setRenderHint(QPainter::SmoothPixmapTransform,
                                w->paint == PAINT_BILINEAR);
    const QImage texture =
        QImage(reinterpret_cast<const uchar *>(workload_texture()),
               TEXTURE_SIDE, TEXTURE_SIDE, QImage::Format_RGB32)
            .convertToFormat(job->image->format());
    job->sprite =
        QImage(reinterpret_cast<const uchar *>(workload_sprite(w->paint)),
               SPRITE_SIDE, SPRITE_SIDE, QImage::Format_ARGB32)
            .convertToFormat(alpha ? QImage::Format_ARGB32_Premultiplied
                             : w->paint == PAINT_CONVERT
                                 ? QImage::Format_RGB32
                                 : job->image->format());
    if (w->paint == PAINT_COPY || w->paint == PAINT_CONVERT)
        job->painter->setCompositionMode(QPainter::CompositionMode_Source);
    if (workload_is_line(w))
        open_text(job);
    job->item = new struct item[static_cast<size_t>(w->count)];
    for (int i = 0; i < w->count; i++)
        job->item[i] = item_of(w, &w->shape[i], texture);
    return job;
}

static void draw_gear(QPainter *painter, const struct offset *gear,
                      QPoint center)
{
    QPointF point[GEAR_SIDES];
    for (int k = 0; k < GEAR_SIDES; k++)
        point[k] = QPointF(center.x() + .5 + gear[k].x / 256.,
                           center.y() + .5 + gear[k].y / 256.);
    painter->drawPolygon(point, GEAR_SIDES);
}

static void draw_text(const struct job *job, const struct item *item)
{
    QPainter *painter = job->painter;
    const QPoint at = item->point[0] + QPoint(0, job->workload->size);
    if (job->workload->form == FORM_OUTLINES) {
        painter->setBrush(item->brush);
        painter->translate(at);
        painter->drawPath(job->path);
        painter->translate(-at);
    } else {
        painter->setPen(item->brush.color());
        painter->drawGlyphRun(at, job->run);
    }
}

static void draw_shape(QPainter *painter, const struct workload *w,
                       const struct item *item)
{
    if (w->form == FORM_LINE) {
        painter->setPen(item->brush.color());
        painter->drawLine(item->point[0], item->point[1]);
        return;
    }
    if (w->form == FORM_SCREEN) {
        painter->fillRect(QRect(0, 0, w->width, w->height), item->brush);
        return;
    }
    if (w->form == FORM_BOX) {
        painter->fillRect(QRect(item->point[0], item->point[1] - QPoint(1, 1)),
                          item->brush);
        return;
    }
    if (w->form == FORM_STROKE)
        painter->setPen(QPen(item->brush, STROKE_WIDTH, Qt::SolidLine,
                             Qt::FlatCap, Qt::RoundJoin));
    else
        painter->setBrush(item->brush);
    if (w->form == FORM_ROUNDED) {
        painter->drawRoundedRect(QRectF(item->point[0], item->point[1]),
                                 ROUNDED_RADIUS, ROUNDED_RADIUS);
        return;
    }
    if (w->form == FORM_CIRCLE)
        painter->drawEllipse(QPointF(item->point[0]) + QPointF(.5, .5), w->size,
                             w->size);
    else if (w->form == FORM_GEAR || w->form == FORM_STROKE)
        draw_gear(painter, workload_gear(w), item->point[0]);
    else if (w->form == FORM_POLYGON)
        painter->drawPolygon(item->point, SHAPE_VERTICES);
    else
        painter->drawConvexPolygon(item->point, 3);
}

static void draw(void *data, int first, int n)
{
    const struct job *job = static_cast<struct job *>(data);
    for (const struct item *item = job->item + first; n > 0; n--, item++)
        if (job->workload->form == FORM_COPY)
            job->painter->drawImage(item->point[0], job->sprite);
        else if (!job->path.isEmpty())
            draw_text(job, item);
        else
            draw_shape(job->painter, job->workload, item);
}

static void close_job(void *data)
{
    struct job *job = static_cast<struct job *>(data);
    delete job->painter;
    delete job->image;
    delete[] job->item;
    delete job;
}

extern "C" {
extern const struct method method_qt5;
const struct method method_qt5 = {"qt5", "packaged", open_job, draw, close_job};
}
