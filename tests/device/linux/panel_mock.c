/* A kernel module for tests: an SPI controller with a spidev, an I2C adapter
 * with a chip at address 0x3c, and a GPIO chip with the lines DC, RESET and
 * LIGHT. What is sent is noted in debugfs, panel-mock/log, in words of 16 bits
 * as tests/support/bus_log.h has them: bytes, plus 0x100 for data, and 0x200
 * when RESET goes low. */
#include <linux/debugfs.h>
#include <linux/gpio/driver.h>
#include <linux/i2c.h>
#include <linux/module.h>
#include <linux/platform_device.h>
#include <linux/spi/spi.h>
#include <linux/vmalloc.h>

enum { MOST = 1 << 20, LINES = 4, ADDRESS = 0x3C };
enum { DC, RESET, LIGHT };

static struct debugfs_blob_wrapper log;
static struct dentry *folder;
static struct platform_device *device;
static struct spi_controller *controller;
static u32 levels;

static void note(u16 word)
{
    if (log.size + 2 <= 2 * MOST) {
        ((u16 *)log.data)[log.size / 2] = word;
        log.size += 2;
    }
}

static void note_bytes(u16 kind, const u8 *bytes, size_t n)
{
    for (size_t i = 0; i < n; i++)
        note(kind | (bytes ? bytes[i] : 0));
}

static int line_get(struct gpio_chip *chip, unsigned line)
{
    return levels >> line & 1;
}

static void line_set(struct gpio_chip *chip, unsigned line, int value)
{
    if (line == RESET && !value)
        note(0x200);
    levels = value ? levels | 1u << line : levels & ~(1u << line);
}

static int line_output(struct gpio_chip *chip, unsigned line, int value)
{
    line_set(chip, line, value);
    return 0;
}

static int line_direction(struct gpio_chip *chip, unsigned line)
{
    return GPIO_LINE_DIRECTION_OUT;
}

static const char *const names[LINES] = {"DC", "RESET", "LIGHT", "SPARE"};

static struct gpio_chip lines = {.label = "panel-mock",
                                 .owner = THIS_MODULE,
                                 .base = -1,
                                 .ngpio = LINES,
                                 .names = names,
                                 .get = line_get,
                                 .set = line_set,
                                 .direction_output = line_output,
                                 .get_direction = line_direction};

static int transfer(struct spi_controller *c, struct spi_device *d,
                    struct spi_transfer *t)
{
    note_bytes(levels & 1u << DC ? 0x100 : 0, t->tx_buf, t->len);
    spi_finalize_current_transfer(c);
    return 0;
}

static int messages(struct i2c_adapter *adapter, struct i2c_msg *m, int n)
{
    for (int i = 0; i < n; i++) {
        if (m[i].addr != ADDRESS)
            return -ENXIO;
        if (!(m[i].flags & I2C_M_RD) && m[i].len)
            note_bytes(m[i].buf[0] == 0x40 ? 0x100 : 0, m[i].buf + 1,
                       m[i].len - 1);
    }
    return n;
}

static u32 functions(struct i2c_adapter *adapter)
{
    return I2C_FUNC_I2C;
}

static const struct i2c_algorithm algorithm = {.master_xfer = messages,
                                               .functionality = functions};
static struct i2c_adapter adapter = {
    .owner = THIS_MODULE, .name = "panel-mock", .algo = &algorithm};

static struct spi_board_info board = {
    .modalias = "dh2228fv", /* one of those that spidev takes */
    .max_speed_hz = 50000000,
};

static int start_spi(void)
{
    int error;
    controller = spi_alloc_master(&device->dev, 0);
    if (!controller)
        return -ENOMEM;
    controller->num_chipselect = 1;
    controller->bits_per_word_mask = SPI_BPW_MASK(8);
    controller->transfer_one = transfer;
    error = spi_register_controller(controller);
    if (error) {
        spi_controller_put(controller);
    } else if (!spi_new_device(controller, &board)) {
        spi_unregister_controller(controller);
        error = -ENODEV;
    }
    return error;
}

/* The first `made` of what init makes, the last first. */
static void undo(int made)
{
    if (made > 2)
        spi_unregister_controller(controller);
    if (made > 1)
        i2c_del_adapter(&adapter);
    if (made > 0)
        gpiochip_remove(&lines);
    platform_device_unregister(device);
    vfree(log.data);
}

static int __init panel_mock_init(void)
{
    int error, made = 0;
    log.data = vmalloc(2 * MOST);
    if (!log.data)
        return -ENOMEM;
    device = platform_device_register_simple("panel-mock", -1, NULL, 0);
    if (IS_ERR(device)) {
        vfree(log.data);
        return PTR_ERR(device);
    }
    lines.parent = &device->dev;
    adapter.dev.parent = &device->dev;
    error = gpiochip_add_data(&lines, NULL);
    if (!error) {
        made = 1;
        error = i2c_add_adapter(&adapter);
    }
    if (!error) {
        made = 2;
        error = start_spi();
    }
    if (error) {
        undo(made);
        return error;
    }
    folder = debugfs_create_dir("panel-mock", NULL);
    debugfs_create_blob("log", 0444, folder, &log);
    debugfs_create_x32("levels", 0444, folder, &levels);
    return 0;
}

static void __exit panel_mock_exit(void)
{
    debugfs_remove(folder);
    undo(3);
}

module_init(panel_mock_init);
module_exit(panel_mock_exit);
MODULE_LICENSE("Dual MIT/GPL");
