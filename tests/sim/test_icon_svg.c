/* SVG files as icons, beside librsvg: those of two themes of icons, and small
 * ones for what they do not have; and the files that are refused. */
#include "files.h"

#include <math.h>

#include "core/pel.h"
#include "sim/icon/icon.h"
#include "sim/image/texture.h"
#include "tests/support/cases.h"

#define TANGO "/usr/share/icons/Tango/scalable/"
#define ADWAITA "/usr/share/icons/Adwaita/scalable/"

/* Public domain, and CC-BY-SA 3.0 by the GNOME Project. */
static const char *const theme[] = {
    TANGO "actions/appointment-new",
    TANGO "actions/document-print",
    TANGO "actions/edit-find-replace",
    TANGO "actions/format-indent-less",
    TANGO "actions/format-text-bold",
    TANGO "actions/go-home",
    TANGO "actions/go-up",
    TANGO "actions/mail-send-receive",
    TANGO "actions/media-seek-forward",
    TANGO "actions/system-shutdown",
    TANGO "apps/accessories-character-map",
    TANGO "apps/preferences-desktop-assistive-technology",
    TANGO "apps/preferences-desktop-screensaver",
    TANGO "apps/system-file-manager",
    TANGO "categories/applications-graphics",
    TANGO "devices/audio-card",
    TANGO "devices/drive-harddisk",
    TANGO "devices/media-floppy",
    TANGO "devices/video-display",
    TANGO "emblems/emblem-unreadable",
    TANGO "emotes/face-plain",
    TANGO "mimetypes/application-certificate",
    TANGO "mimetypes/text-html",
    TANGO "mimetypes/x-office-presentation",
    TANGO "places/start-here",
    TANGO "status/dialog-warning",
    TANGO "status/mail-attachment",
    TANGO "status/network-transmit",
    TANGO "status/weather-snow",
    ADWAITA "actions/application-exit-rtl-symbolic",
    ADWAITA "actions/edit-copy-symbolic",
    ADWAITA "actions/format-text-direction-symbolic-rtl",
    ADWAITA "actions/list-remove-all-symbolic",
    ADWAITA "actions/media-view-subtitles-symbolic",
    ADWAITA "actions/view-app-grid-symbolic",
    ADWAITA "actions/view-sort-descending-symbolic-rtl",
    ADWAITA "devices/audio-headphones-symbolic",
    ADWAITA "devices/input-keyboard-symbolic",
    ADWAITA "devices/tv-symbolic",
    ADWAITA "emotes/face-raspberry-symbolic",
    ADWAITA "legacy/gnome-power-manager-symbolic",
    ADWAITA "legacy/system-software-install-symbolic",
    ADWAITA "places/folder-publicshare-symbolic",
    ADWAITA "status/audio-volume-overamplified-rtl-symbolic",
    ADWAITA "status/bluetooth-acquiring-symbolic",
    ADWAITA "status/keyboard-brightness-symbolic",
    ADWAITA "status/network-cellular-disabled-symbolic",
    ADWAITA "status/network-idle-symbolic",
    ADWAITA "status/network-wireless-signal-weak-symbolic",
    ADWAITA "status/security-medium-symbolic-rtl"};

enum { SIDE = 48 };

static void draw_by_librsvg(struct picture *picture, const char *path,
                            const struct picture *like)
{
    char command[512];
    char *png = file_with("", 0);
    snprintf(command, sizeof command, "rsvg-convert -w %d -h %d '%s' >'%s'",
             like->width, like->height, path, png);
    if (system(command) != 0)
        fail_msg("%s: librsvg2-bin, tango-icon-theme and adwaita-icon-theme "
                 "are wanted",
                 command);
    assert_true(texture_load(picture, png));
    unlink(png);
    free(png);
}

/* The mean difference of a channel on a background, in steps of 255. */
static double difference(const struct picture *a, const struct picture *b,
                         pel_color background)
{
    const int n = a->width * a->height;
    long sum = 0;
    assert_int_equal(a->width, b->width);
    assert_int_equal(a->height, b->height);
    for (int i = 0; i < n; i++) {
        const pel_color p =
            pel_mix(background, a->pixels[i], pel_alpha(a->pixels[i]));
        const pel_color q =
            pel_mix(background, b->pixels[i], pel_alpha(b->pixels[i]));
        for (int shift = 0; shift < 24; shift += 8)
            sum += abs((int)(p >> shift & 255) - (int)(q >> shift & 255));
    }
    return (double)sum / 3 / n;
}

/* The larger of those on black and on white. */
static double compare(const char *path)
{
    struct pel_icon_asset icon;
    struct picture own, other;
    assert_true(icon_load(&icon, path));
    assert_true(icon_picture(&own, &icon, SIDE));
    draw_by_librsvg(&other, path, &own);
    const double mean = fmax(difference(&own, &other, PEL_RGB(0, 0, 0)),
                             difference(&own, &other, PEL_RGB(255, 255, 255)));
    picture_free(&own);
    picture_free(&other);
    icon_free(&icon);
    return mean;
}

TEST(themes_look_as_by_librsvg)
{
    enum { N = sizeof theme / sizeof *theme };
    double sum = 0, worst = 0;
    for (int i = 0; i < N; i++) {
        char path[256];
        snprintf(path, sizeof path, "%s.svg", theme[i]);
        const double mean = compare(path);
        if (mean >= 1)
            fail_msg("%s: the mean difference is %.2f of 255", path, mean);
        sum += mean;
        worst = fmax(worst, mean);
    }
    printf("%d icons: mean difference %.2f of 255, %.2f of the worst\n", N,
           sum / N, worst);
    assert_true(sum / N < 0.4);
}

#define BEGIN "<svg xmlns=\"http://www.w3.org/2000/svg\" "
#define SMALL BEGIN "width=\"48\" height=\"48\">\n"
#define END "</svg>\n"

/* What themes have seldom or never. No gradient of a stroke by the box of its
 * shape: librsvg takes the stroke into it, against the standard. */
static const char *const small[] = {
    SMALL "<rect x='4' y='6' width='30' height='20' rx='5' fill='#c00'/>"
          "<rect x='20' y='20' width='20' height='25' rx='3' ry='9' "
          "fill='rgb(10%, 80%, 8%)' fill-opacity='.5'/>" END,
    SMALL "<circle cx='20' cy='20' r='13.5' fill='none' stroke='navy' "
          "stroke-width='5'/><ellipse cx='30' cy='30' rx='15' ry='7' "
          "transform='rotate(30 30 30)' fill='orange'/>" END,
    SMALL "<polygon points='24,3 40,45 3,18 45,18 8,45' fill-rule='evenodd' "
          "style='fill:#264;stroke:#000;stroke-linejoin:bevel'/>" END,
    SMALL "<polyline points='4 4 44 10 6 24 40 40' fill='none' stroke='#639' "
          "stroke-width='6' stroke-linejoin='round' stroke-linecap='round'/>"
          "<line x1='2' y1='46' x2='46' y2='46' stroke='red' "
          "stroke-width='2mm' stroke-linecap='square'/>" END,
    SMALL "<path d='M10 24a14 14 0 1 1 28 0 14 14 0 01-28 0zm6 0A8 4 40 0 0 "
          "30,24q2 9-6 4t-4-4' fill='teal' fill-rule='evenodd'/>"
          "<path d='m4 40h9v3H4zM20 40c3-9 6 9 9 0s6 9 9 0' fill='none' "
          "stroke='#000' stroke-width='1.5'/>" END,
    SMALL "<path d='M5 5H43V20L20 43' fill='none' stroke='#a50' "
          "stroke-width='4' stroke-miterlimit='1'/><path d='M10 44 24 20l14 "
          "24' fill='none' stroke='#05a' stroke-width='4'/>" END,
    SMALL "<defs><linearGradient id='a'><stop offset='0.2' stop-color='#f00'/>"
          "<stop offset='50%' stop-color='#0f0' stop-opacity='.5'/><stop "
          "offset='1' style='stop-color:#00f'/></linearGradient>"
          "<linearGradient id='b' xmlns:x='http://www.w3.org/1999/xlink' "
          "x:href='#a' x1='0' y1='0' x2='.3' y2='.4' spreadMethod='reflect' "
          "gradientTransform='rotate(10)'/></defs><rect x='2' y='2' "
          "width='44' height='20' fill='url(#a)'/><rect x='2' y='24' "
          "width='44' height='22' fill='url(#b)'/>" END,
    SMALL
    "<radialGradient id='c' gradientUnits='userSpaceOnUse' cx='24' "
    "cy='24' r='20' fx='34' fy='20' gradientTransform='translate(0 4) "
    "scale(1 .8)'><stop offset='0' stop-color='#fff'/><stop offset='1' "
    "stop-color='#124'/></radialGradient><radialGradient id='d' "
    "gradientUnits='userSpaceOnUse' spreadMethod='repeat' cx='24' cy='24' "
    "r='14'><stop offset='0' stop-color='#fa0'/>"
    "<stop offset='1' stop-color='#a0f'/></radialGradient><g "
    "transform='matrix(.9 .1 -.1 .9 3 0)'><path d='M3 3H45V45H3z' "
    "fill='url(#c)' stroke='url(#d)' stroke-width='6'/></g>" END,
    BEGIN "viewBox='-10 -5 100 60' width='64px' height='64'><g opacity='.5'>"
          "<path d='M-10-5h50v30h-50z'/><path d='M40 25h50v30H40z'/></g>"
          "<g display='none'><rect width='99' height='99'/></g>"
          "<g style='fill:currentColor;visibility:hidden'><path d='M0 0h9v9z'/>"
          "<path visibility='visible' d='M60 0h20v20z'/></g>" END};

TEST(shapes_look_as_by_librsvg)
{
    for (size_t i = 0; i < sizeof small / sizeof *small; i++) {
        char *const path = file_with(small[i], strlen(small[i]));
        const double mean = compare(path);
        unlink(path);
        free(path);
        if (mean >= 0.6)
            fail_msg("%zu: the mean difference is %.2f: %s", i, mean, small[i]);
    }
}

static const struct {
    const char *text, *told;
} refused[] = {
    {"<svg><g/></svg>", "is no SVG"},
    {"<svg", "expected an SVG file"},
    {SMALL "<g>", "expected an SVG file"},
    {SMALL END, "draws nothing"},
    {BEGIN ">" END, "has no size"},
    {BEGIN "width='48' height='24' viewBox='0 0 9 9' "
           "preserveAspectRatio='xMidYMid slice'><path d='M1 1h9v9'/>" END,
     "preserveAspectRatio is 'xMidYMid slice'"},
    {SMALL "<text>a</text>" END, ":2: <text>, which pel does not draw"},
    {SMALL "\n<use href='#a'/>" END, ":3: <use>, which"},
    {SMALL "<image/>" END, "<image>, which"},
    {SMALL "<svg/>" END, "<svg>, which"},
    {SMALL "<rect width='9' height='9'><animate/></rect>" END, "<animate>"},
    {SMALL "<style>.a { fill: red }</style>" END, "rules of CSS"},
    {SMALL "<g filter='url(#a)'/>" END, "filter is 'url(#a)'"},
    {SMALL "<g style='mask: url(#m)'/>" END, "mask is 'url(#m)'"},
    {SMALL "<g clip-path='url(#a)'/>" END, "clip-path is 'url(#a)'"},
    {SMALL "<g style='mix-blend-mode:multiply'/>" END, "mix-blend-mode"},
    {SMALL "<path d='M1 1h9' marker-end='url(#a)'/>" END, "marker-end"},
    {SMALL "<path d='M1 1h9v9' fill='url(#no)'/>" END, "no gradient 'no'"},
    {SMALL "<pattern id='p'><text/></pattern>"
           "<path d='M1 1h9v9' fill='url(#p)'/>" END,
     "no gradient 'p'"},
    {SMALL "<path d='M1 1h9v9' fill='salmon'/>" END, "the colour 'salmon'"},
    {SMALL "<path d='M1 1h9v' fill='red'/>" END, "path data is wrong at"},
    {SMALL "<path d='L1 1' fill='red'/>" END, "path data is wrong at"},
    {SMALL "<g transform='turn(3)'/>" END, "transform is 'turn(3)'"},
    {SMALL "<path d='M1 1h9' stroke='red' stroke-dasharray='1 2'/>" END,
     "stroke-dasharray"},
    {SMALL "<path d='M1 1h9' stroke='red' stroke-width='4' "
           "transform='scale(1 3)'/>" END,
     "wider one way than the other"},
    {SMALL "<path d='M1 1h9v9z' stroke='red' opacity='.5'/>" END,
     "opacity of what lies over each other"},
    {SMALL "<g opacity='.5'><path d='M1 1h9v9'/><path d='M1 1h9v9'/></g>" END,
     "opacity of what lies over each other"},
    {SMALL "<path d='M1 1h9e6v9z'/>" END, "reaches too far"},
    {SMALL "<rect width='1e' height='9'/>" END, "width is '1e'"}};

TEST(what_is_not_drawn_is_refused_by_name)
{
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
        char *const path = file_with(refused[i].text, strlen(refused[i].text));
        struct pel_icon_asset icon;
        struct messages m;
        messages_begin(&m);
        const bool done = icon_load(&icon, path);
        messages_end(&m);
        unlink(path);
        free(path);
        if (done || !strstr(m.text, refused[i].told))
            fail_msg("%s: %s, not %s", refused[i].text, m.text,
                     refused[i].told);
        assert_int_equal(icon.parts, 0);
    }
}

/* Draws an icon at random sizes, angles and places in memory for so many sides.
 * A column of pixels has all of them in its rows. */
static void draw_anywhere(const struct pel_icon_asset *icon, int32_t sides)
{
    static uint8_t pixels[3 * ICON_SCRATCH_SIZE_MAX];
    static uint64_t scratch[1 << 16];
    const struct pel_rect column = {0, 0, 1, sizeof pixels};
    struct pel_icon_shape shape = {.icon = icon, .kind = icon_kind(icon, true)};
    struct pel_surface surface;
    pel_surface_init(&surface, &pel_gray8, pixels, sizeof pixels, &column);
    for (struct cases c = cases_of(700); cases_next(&c);) {
        struct random *const r = &c.random;
        const int32_t most = random_word(r) % 2 ? 8 : ICON_SCRATCH_SIZE_MAX;
        const int32_t size =
            random_between(r, PEL_PX(ICON_SCRATCH_SIZE_MIN), PEL_PX(most));
        const struct pel_point at = {128,
                                     PEL_PX(384) + random_between(r, 0, 255)};
        pel_icon_place(&shape, size, (int32_t)random_word(r) >> 8, at);
        if (pel_icon(&surface, &shape, scratch,
                     PEL_ICON_SCRATCH_SIZE(sides, 1)) != PEL_OK)
            fail_msg("%d sides at %d / 256 px; %s", sides, size,
                     cases_replay());
    }
}

TEST(scratch_is_enough)
{
    static const char *const path[] = {
        ADWAITA "status/network-cellular-signal-good-rtl-symbolic.svg",
        TANGO "apps/text-editor.svg", "docs/pictures/icon_gear.svg"};
    for (int i = 0; i < 3; i++) {
        struct pel_icon_asset icon;
        struct icon_need need;
        assert_true(icon_load(&icon, path[i]));
        assert_true(icon_need(&need, &icon));
        draw_anywhere(&icon, need.sides);
        icon_free(&icon);
    }
}
