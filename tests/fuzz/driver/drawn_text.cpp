#include "drawn_text.h"

namespace fuzz_driver {

namespace {

std::string drawOrdinary(Random &random) {
    const auto whole = static_cast<long>(random.below(2001)) - 1000;
    switch (random.below(4)) {
        case 0:
            return std::to_string(random.below(12));
        case 1:
            return std::to_string(whole);
        default:
            return std::to_string(static_cast<double>(whole) / (1 + static_cast<double>(random.below(1000))));
    }
}

}  // namespace

std::string drawNumber(Random &random) {
    static const std::vector<std::string> extremes = {"0",
                                                      "-0",
                                                      "1e-9",
                                                      "1e-20",
                                                      "1e-300",
                                                      "1e-310",
                                                      "4.9e-324",
                                                      "1e-400",
                                                      "1e16",
                                                      "1e17",
                                                      "1e154",
                                                      "1e300",
                                                      "1.8e308",
                                                      "1e400",
                                                      "-1e16",
                                                      "-1e400",
                                                      "nan",
                                                      "-nan",
                                                      "inf",
                                                      "-inf",
                                                      "infinity",
                                                      "INF",
                                                      "2147483647",
                                                      "2147483648",
                                                      "4294967295",
                                                      "4294967296",
                                                      "-2147483649",
                                                      "9223372036854775807",
                                                      "9223372036854775808",
                                                      "18446744073709551616",
                                                      "65535",
                                                      "65536",
                                                      "1000000000",
                                                      "1000000001"};
    static const std::vector<std::string> odd = {"+1",  "++1", "--1",    "01",    "0x10",  "1.",  ".5",
                                                 ".",   "1e",  "e1",     "1,5",   "1_000", "1f",  "1 ",
                                                 " 1",  "\t1", "1\n",    "1e+1",  "1E1",   "0b1", "1d",
                                                 "Inf", "NAN", "nan(1)", "1e1e1", "1-",    "٣",   "１"};
    const std::size_t kind = random.below(10);
    return kind < 5 ? drawOrdinary(random) : kind < 9 ? random.of(extremes) : random.of(odd);
}

std::string drawGarbage(Random &random) {
    static const std::vector<std::string> words = {
        "",          " ",        "\n",        "\t\r\n", "auto", "true",  "false",        "default",
        "none",      "-",        "--",        "--help", "*",    "~",     "..",           "/",
        "/dev/null", "%s%s%n%n", "%1000000d", "'",      "\"",   "\\",    "a,b",          ",",
        ",,",        ":",        ":1",        "=",      "<a/>", "&amp;", "\x1b[31mred",  "\a",
        "\x7f",      "\xc2\x80", "\xff\xfe",  "\xc3",   "é",    "名",    "\xed\xa0\x80", "\xf0\x9f\x98\x80",
        "$(id)",     "`id`",     "{}",        "[]",     "null"};
    if (random.oneIn(8))
        return std::string(1 + random.below(40000), static_cast<char>('a' + random.below(26)));
    if (random.oneIn(4)) {
        std::string bytes(1 + random.below(12), '\0');
        for (char &byte : bytes) byte = static_cast<char>(1 + random.below(255));
        return bytes;
    }
    return random.of(words);
}

std::string drawText(Random &random) {
    switch (random.below(4)) {
        case 0:
            return drawGarbage(random);
        case 1: {
            std::string numbers = drawNumber(random);
            for (std::size_t more = random.below(8); more > 0; --more)
                numbers += (random.oneIn(8) ? "," : " ") + drawNumber(random);
            return numbers;
        }
        default:
            return drawNumber(random);
    }
}

}  // namespace fuzz_driver
