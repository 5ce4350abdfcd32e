/* Qt 5: a QPainter without antialiasing on a QImage, one brush for a shape. */
#include <cstdlib>

#include <QImage>
#include <QPainter>
#include <QPolygon>

extern "C" {
#include "method.h"
}

struct item {
    QPoint point[SHAPE_VERTICES];
    QColor color;
};

struct job {
    const struct workload *workload;
    QImage *image;
    QPainter *painter;
    struct item *item;
};

static struct item item_of(const struct workload *w, const struct shape *s)
{
    struct item item;
    for (int k = 0; k < SHAPE_VERTICES; k++)
        item.point[k] = QPoint(s->x[k], s->y[k]);
    item.color = QColor::fromRgb(s->color[0]);
    if (w->paint == PAINT_ALPHA)
        item.color.setAlpha(WORKLOAD_ALPHA);
    return item;
}

static void *open_job(const struct workload *w, const struct canvas *c)
{
    if (w->paint == PAINT_GOURAUD)
        return nullptr;
    struct job *job = new struct job;
    job->workload = w;
    job->image =
        new QImage(c->pixels, c->width, c->height, c->stride,
                   c->bits == 32 ? QImage::Format_RGB32 : QImage::Format_RGB16);
    job->painter = new QPainter;
    if (!job->painter->begin(job->image))
        method_fail("Qt 5 refuses the canvas", "check its installation");
    job->painter->setPen(Qt::NoPen);
    job->item = new struct item[static_cast<size_t>(w->count)];
    for (int i = 0; i < w->count; i++)
        job->item[i] = item_of(w, &w->shape[i]);
    return job;
}

static void draw_shape(QPainter *painter, const struct workload *w,
                       const struct item *item)
{
    if (w->form == FORM_LINE) {
        painter->setPen(item->color);
        painter->drawLine(item->point[0], item->point[1]);
        return;
    }
    painter->setBrush(item->color);
    if (w->form == FORM_CIRCLE)
        painter->drawEllipse(QPointF(item->point[0]) + QPointF(.5, .5), w->size,
                             w->size);
    else if (w->form == FORM_POLYGON)
        painter->drawPolygon(item->point, SHAPE_VERTICES);
    else
        painter->drawConvexPolygon(item->point, 3);
}

static void draw(void *data, int first, int n)
{
    const struct job *job = static_cast<struct job *>(data);
    for (const struct item *item = job->item + first; n > 0; n--, item++)
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
