/* E-paper on a Linux board whose system calls are played here: its glass shows
 * what was flipped, BUSY is waited for, and every call fails once. */
#include "tests/support/check.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include <pel/pel.h>

#include "panel_calls.h"

/* E-paper, with the size of the glass. */
static const struct {
    const char *name;
    enum paper_family family;
    int size[2];
    bool color, gray;
} papers[] = {
    {"ssd1680", PAPER_SSD, {122, 250}, false, false},
    {"ssd1680_gray2", PAPER_SSD, {122, 250}, false, true},
    {"ssd1681_inks2", PAPER_SSD, {200, 200}, true, false},
    {"uc8151_gray2", PAPER_UC8151, {128, 296}, false, true},
    {"uc8179", PAPER_UC8179, {800, 480}, false, false},
};
enum { PAPERS = sizeof papers / sizeof *papers };

static bool is_mono(int i)
{
    return !papers[i].color && !papers[i].gray;
}

static int open_paper(int i)
{
    struct pel_panel_request request;
    char name[160];
    paper.family = papers[i].family;
    paper.width = papers[i].size[0];
    paper.height = papers[i].size[1];
    paper.color = papers[i].color;
    paper.gray = papers[i].gray;
    paper_glass_init(&paper);
    is_paper = true;
    calls = lines_open = 0;
    message.text[0] = 0;
    snprintf(name, sizeof name,
             "%s,spi=/dev/spidev0.0,speed=4M,dc=GPIO25,reset=gpiochip0:27,"
             "busy=GPIO24%s",
             papers[i].name, is_mono(i) ? ",partial" : "");
    assert_int_equal(pel_panel_parse(&request, name, &message), 0);
    const int error = pel_display_panel_open(&panel, &request, &message);
    return error ? error : pel_display_panel_start(&display, &panel, &request);
}

static void close_paper(void)
{
    pel_display_panel_close(&panel);
    assert_int_equal(lines_open, 0);
    is_paper = false;
}

/* The whole of it black, or white. */
static enum pel_status show(bool white)
{
    const struct pel_rect whole = {0, 0, display.width, display.height};
    struct pel_surface s;
    assert_int_equal(pel_display_begin(&display, &whole, &s), PEL_OK);
    pel_clear(&s, white ? PEL_RGB(255, 255, 255) : PEL_RGB(0, 0, 0));
    enum pel_status status = pel_display_flush(&display, &s);
    return status == PEL_OK ? pel_display_flip(&display) : status;
}

TEST(paper_shows_frames)
{
    for (int i = 0; i < PAPERS; i++) {
        const int later = is_mono(i) ? PEL_EPAPER_PARTIAL : PEL_EPAPER_FULL;
        assert_int_equal(open_paper(i), 0);
        assert_int_equal(display.width, papers[i].size[0]);
        for (int n = 0; n < 4; n++) {
            assert_int_equal(show(n % 2), PEL_OK);
            assert_int_equal(paper.refreshes, n + 1);
            assert_int_equal(panel.paper.refresh, later);
            const int shown = n % 2            ? paper.white
                              : papers[i].gray ? PAPER_GRAY
                                               : PAPER_BLACK;
            for (int k = 0; k < paper.width * paper.height; k++)
                assert_int_equal(paper.shown[k], shown);
        }
        close_paper();
        assert_true(paper.asleep);
    }
}

/* A line BUSY that is another one, and calls that fail. */
TEST(paper_that_stays_busy)
{
    assert_int_equal(open_paper(0), 0);
    assert_int_equal(show(true), PEL_OK);
    paper.stuck = true;
    paper.ms = 0;
    assert_int_equal(show(false), PEL_ERROR_DEVICE);
    assert_in_range(paper.ms, 60000, 61000);
    assert_non_null(strstr(message.text, "busy for a minute"));
    close_paper();
    paper.stuck = false;
}

TEST(paper_and_every_call_that_fails)
{
    const int files = next_descriptor();
    error_given = EIO;
    for (int i = 0; i < 2; i++) {
        bool over = false;
        for (int n = 1; !over; n++) {
            fail_at = n;
            int error = open_paper(i);
            if (!error)
                error = show(false);
            if (!error)
                error = show(true);
            over = calls < fail_at;
            if (over != (error == 0))
                fail_msg("%s: call %d", papers[i].name, n);
            assert_int_equal(error != 0, message.text[0] != 0);
            fail_at = 0;
            paper.busy = 0;
            close_paper();
            assert_int_equal(next_descriptor(), files);
        }
    }
}

TEST(paper_that_is_refused)
{
    static const char *const names[][2] = {
        {"ssd1680,spi=/dev/a,dc=GPIO25", "busy=LINE"},
        {"ssd1680,spi=/dev/a,dc=GPIO25,busy=GPIO24,inverted", "e-paper"},
        {"ssd1680_gray2,spi=/dev/a,dc=GPIO25,busy=GPIO24,partial", "black"},
        {"il3897,spi=/dev/a,dc=GPIO25,busy=GPIO24,partial", "waveform"},
        {"uc8151,spi=/dev/a,dc=GPIO25,busy=GPIO24,partial", "waveform"},
        {"ssd1680,spi=/dev/a,dc=GPIO25,busy=GPIO24,size=9999x9", "memory"},
        {"ssd1234,spi=/dev/a,dc=GPIO25", "uc8179_gray2"}};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        struct pel_panel_request request;
        calls = 0;
        assert_int_equal(pel_panel_parse(&request, names[i][0], &message), 0);
        int error = pel_display_panel_open(&panel, &request, &message);
        if (!error)
            error = pel_display_panel_start(&display, &panel, &request);
        assert_int_equal(error, EINVAL);
        assert_non_null(strstr(message.text, names[i][1]));
        pel_display_panel_close(&panel);
    }
}
