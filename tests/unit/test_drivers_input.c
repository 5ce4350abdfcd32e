/* Buttons, encoders and the queue: what they are told, letter by letter, and
 * what they tell. */
#include "tests/support/check.h"

#include <string.h>

#include "drivers/input_button.h"
#include "drivers/input_encoder.h"

/* A level each millisecond; P it is pressed, R released. */
TEST(button)
{
    static const struct {
        int hold;
        const char *levels, *told;
    } rows[] = {
        {3, "0111110000000", "....P....R..."},
        {3, "0101101111111", ".........P..."}, /* bounces */
        {3, "0110110110110", "............."}, /* a bad contact */
        {3, "0111101111001", "....P........"}, /* one that lets go */
        {3, "1111000011110", "...P...R...P."}, /* pressed from the start */
        {0, "0110100000000", ".P.RPR......."},
        {1, "0110100110000", "..P...R.P.R.."}, /* too short for it */
    };
    for (size_t i = 0; i < sizeof(rows) / sizeof(rows[0]); i++) {
        struct pel_button button = {.code = 'x',
                                    .hold = (uint16_t)rows[i].hold};
        struct pel_input e;
        char told[16] = "";
        for (uint32_t t = 0; rows[i].levels[t]; t++) {
            const uint32_t time = t - 2; /* which wraps */
            const bool is =
                pel_button_update(&button, rows[i].levels[t] == '1', time, &e);
            told[t] = (char)(!is ? '.' : e.state == PEL_INPUT_DOWN ? 'P' : 'R');
            if (is) {
                assert_int_equal(e.kind, PEL_INPUT_KEY);
                assert_int_equal(e.code, 'x');
                assert_int_equal((int)(time - e.time), rows[i].hold);
            }
        }
        if (strcmp(told, rows[i].told) != 0)
            fail_msg("row %d: %s, expected %s", (int)i, told, rows[i].told);
    }
}

/* Contacts, A * 2 + B; + and - are detents. */
TEST(encoder)
{
    static const struct {
        int states;
        const char *contacts, *told;
    } rows[] = {
        {4, "02310231", "....+..."},
        {4, "013201320", "....-...-"},
        {4, "02023231310102310", "..........+.....+"}, /* bounces */
        {4, "0202020", "......."}, /* one contact closes and opens */
        {4, "02320", "....."},     /* half way and back */
        {4, "0310", "...+"},       /* both were missed: half is enough */
        {4, "030", "..."},         /* and this may be either way */
        {4, "0230", "...+"},
        {4, "0130", "...-"},
        {4, "0210", "...+"},
        {4, "02121210231", "...+.+.+..."}, /* detents that nobody saw */
        {2, "0231023", "..+.+.+"},
        {2, "0132013", "..-.-.-"},
        {2, "0202313", "....+.."},
        {2, "02010", "....."},
    };
    for (size_t i = 0; i < sizeof(rows) / sizeof(rows[0]); i++) {
        struct pel_encoder encoder = {.states = (uint8_t)rows[i].states};
        char told[32] = "";
        for (int t = 0; rows[i].contacts[t]; t++) {
            const int state = rows[i].contacts[t] - '0';
            const int turned =
                pel_encoder_update(&encoder, state >> 1, state & 1);
            told[t] = "-.+"[turned + 1];
        }
        if (strcmp(told, rows[i].told) != 0)
            fail_msg("row %d: %s, expected %s", (int)i, told, rows[i].told);
    }
}

/* Letters go in; < takes one out: it, ! for what was lost, - for nothing. */
TEST(queue)
{
    static const char does[] = "<ab<<<abcdefg<h<<<<ij<<k<<<";
    static const char told[] = "-ab-abc!!ijk--";
    struct pel_input places[5] = {{.time = 0}}, e = {.kind = PEL_INPUT_KEY};
    struct pel_input_queue queue = PEL_INPUT_QUEUE(places);
    uint16_t seen = 0;
    char text[sizeof(told)] = "";
    for (size_t i = 0, n = 0; does[i]; i++) {
        e.code = (uint16_t)does[i];
        if (does[i] != '<') {
            const bool fits = !strchr("defgh", does[i]);
            assert_int_equal(pel_input_push(&queue, &e), fits);
            assert_int_equal(pel_input_lost(&queue, &seen), !fits);
        } else if (!pel_input_pop(&queue, &e)) {
            text[n++] = '-';
        } else {
            text[n++] = (char)(e.kind == PEL_INPUT_LOST ? '!' : e.code);
        }
        e.kind = PEL_INPUT_KEY;
    }
    assert_string_equal(text, told);
    e.kind = PEL_INPUT_LOST; /* by a driver */
    assert_true(pel_input_push(&queue, &e));
    assert_true(pel_input_lost(&queue, &seen));
    assert_false(pel_input_lost(&queue, &seen));
}
