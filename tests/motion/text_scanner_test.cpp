#include "rigless/motion/detail/text_scanner.h"

#include <doctest/doctest.h>

#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

using namespace rigless;
using namespace rigless::detail;

TEST_CASE("scan_number agrees with the C library") {
  const char* numbers[] = {"0",
                           "-0",
                           "1",
                           "+1.5",
                           "-.5",
                           "5.",
                           "1e3",
                           "1E-05",
                           "1e+2",
                           "7.62852e-016",
                           "123456789.123456789",
                           "0.1",
                           "1e22",
                           "1e-22",
                           "3.4028235e38",
                           "1.7976931348623157e308",
                           "2.2250738585072014e-308",
                           "12345678901234567890123",
                           "1e-400",
                           "0.000000000000000000000000123",
                           "0e999",
                           "0000000000000000000000000000001.5"};
  for (const char* text : numbers) {
    CAPTURE(text);
    double value = -1;
    CHECK(scan_number(text, value) == std::string(text).size());
    CHECK(value == doctest::Approx(std::strtod(text, nullptr)).epsilon(1e-15));
  }
}

TEST_CASE("scan_number is exact for the digits that motion files have") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1000, 1000);
  for (int i = 0; i < 20000; ++i) {
    char text[64];
    std::snprintf(text, sizeof text, i % 2 == 0 ? "%.6f" : "%.9g", uniform(random));
    double value = 0;
    REQUIRE(scan_number(text, value) == std::string(text).size());
    REQUIRE(value == std::strtod(text, nullptr));
  }
}

TEST_CASE("scan_number refuses what is not a finite number") {
  for (const char* text :
       {"", "-", "+", ".", "e5", "nan", "inf", "-inf", "NaN", "--1", "1e999", "x", "-1.#IND", "\xff"}) {
    CAPTURE(text);
    double value = 7;
    const std::size_t used = scan_number(text, value);
    CHECK(used < std::string(text).size() + (text[0] == '\0' ? 1 : 0));
  }
  double value = 7;
  CHECK(scan_number("nan", value) == 0);
  CHECK(scan_number("1e999", value) == 0);
  CHECK(value == 7);
  CHECK(scan_number("1e", value) == 1);
}

TEST_CASE("words know their lines whatever ends them") {
  for (const char* text : {"a\n# note\n\nb { c", "a\r\n# note\r\n\r\nb { c", "a\r# note\r\rb { c",
                           "\xEF\xBB\xBF"
                           "a\n//\n\nb{c"}) {
    TextScanner scanner(text);
    CHECK(scanner.word() == "a");
    CHECK(scanner.line() == 1);
    CHECK(scanner.peek() == "b");
    CHECK(scanner.word() == "b");
    CHECK(scanner.line() == 4);
    CHECK(scanner.word() == "{");
    CHECK(scanner.word() == "c");
    CHECK(scanner.word().empty());
    CHECK_FALSE(scanner.more());
    CHECK(scanner.line() == 4);
  }
}

TEST_CASE("numbers: commas, ends and errors") {
  TextScanner scanner("0,033 1, 2 # 9\n3} 1,2,3");
  double value = 0;
  for (const double expected : {0.033, 1.0, 2.0, 3.0}) {
    CHECK(scanner.number(value).ok());
    CHECK(value == expected);
  }
  CHECK(scanner.word() == "}");
  const Status status = scanner.number(value);
  CHECK(status.error == Error::bad_number);
  CHECK(status.where == 2);
  CHECK(TextScanner(" \n").number(value).error == Error::unexpected_end);
}

TEST_CASE("rest_of_line keeps spaces, colons and hashes of a name") {
  CHECK(TextScanner(" Bip01 L Foot \n{").rest_of_line('{') == "Bip01 L Foot");
  CHECK(TextScanner("mixamorig:Hips{").rest_of_line('{') == "mixamorig:Hips");
  CHECK(TextScanner("Foot#2 # the second\n").rest_of_line('{') == "Foot#2");
  CHECK(TextScanner("\n{").rest_of_line('{').empty());
}
