/* The text behind panel: of --device, and what is said of a wrong one. */
#include "tests/support/check.h"

#include <errno.h>
#include <string.h>

#include "drivers/display_linux_panel.h"

TEST(names)
{
    static const char *const names[][2] = {
        {"", "spi=/dev"},
        {"st7789,spi=a", "dc=LINE"},
        {"st7789,spi=a,i2c=b", "spi=/dev"},
        {"st7789,spi=a,dc=b,rotation=45", "0, 90, 180 or 270"},
        {"st7789,spi=a,dc=b,rotation=360", "0, 90, 180 or 270"},
        {"st7789,spi=a,dc=b,size=240", "240x240"},
        {"st7789,spi=a,dc=b,size=-1x9", "240x240"},
        {"st7789,spi=a,dc=b,offset=1x2x3", "52x40"},
        {"st7789,spi=a,dc=b,speed=0", "32M"},
        {"st7789,spi=a,dc=b,speed=5000M", "32M"},
        {"st7789,spi=a,dc=b,brightness=256", "0 to 255"},
        {"ssd1306,i2c=a,address=128", "0x3c"},
        {"st7789,spi=a,dc=b,mode=4", "0 to 3"},
        {"st7789,spi=a,dc=", "OPTION=VALUE"},
        {"st7789,colour=blue", "spi, mode"}};
    struct pel_panel_request request;
    struct pel_message message;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        assert_int_equal(pel_panel_parse(&request, names[i][0], &message),
                         EINVAL);
        assert_non_null(strstr(message.text, names[i][1]));
    }
    assert_int_equal(
        pel_panel_parse(&request, "st7789,spi=a,dc=b,offset=0x20", &message),
        0);
    assert_int_equal(request.left, 0);
    assert_int_equal(request.top, 20);
    struct pel_display_panel panel;
    strcpy(request.text, "uc1701");
    request.chip = request.text;
    assert_int_equal(pel_display_panel_open(&panel, &request, &message),
                     EINVAL);
    assert_non_null(strstr(message.text, "unknown panel 'uc1701'"));
    assert_non_null(strstr(message.text, "one of st7789, st7735, "));
    assert_non_null(strstr(message.text, ", pcd8544"));
}
