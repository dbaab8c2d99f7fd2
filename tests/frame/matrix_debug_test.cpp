// The helpers that print, fill and compare matrices, against Debian's library.
//
// Covers api/misc.cpp.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "DebianOde.h"

namespace {

constexpr dReal kNaN = std::numeric_limits<dReal>::quiet_NaN();

// A matrix by rows, each as long as ODE pads it; the padding holds a mark.
struct Matrix {
    Matrix(int rows, int columns) : rows(rows), columns(columns), numbers(rows * stride() + 1, 77) {}
    int stride() const { return columns > 1 ? (columns + 3) & ~3 : columns; }
    dReal &at(int row, int column) { return numbers[row * stride() + column]; }

    int rows, columns;
    std::vector<dReal> numbers;
};

struct Size {
    int rows, columns;
};
void PrintTo(const Size &size, std::ostream *out) { *out << size.rows << "x" << size.columns; }
constexpr Size kSizes[] = {{1, 1}, {1, 3}, {4, 1}, {3, 4}, {5, 7}, {6, 6}, {9, 2}, {0, 5}, {5, 0}};

class MatrixDebug : public testing::TestWithParam<Size> {
protected:
    void SetUp() override {
        if (!debianOde::kSamePrecision) GTEST_SKIP() << "another dReal";
    }

    Matrix random(unsigned long seed) {
        Matrix matrix(GetParam().rows, GetParam().columns);
        dRandSetSeed(seed);
        dMakeRandomMatrix(matrix.numbers.data(), matrix.rows, matrix.columns, 5);
        return matrix;
    }
};

TEST_P(MatrixDebug, FillsAsDebian) {
    Matrix other(GetParam().rows, GetParam().columns);
    debianOde::function(dRandSetSeed, "dRandSetSeed")(3);
    debianOde::function(dMakeRandomMatrix, "dMakeRandomMatrix")(other.numbers.data(), other.rows,
                                                                other.columns, 5);
    EXPECT_EQ(random(3).numbers, other.numbers);
    EXPECT_EQ(dRandGetSeed(), debianOde::function(dRandGetSeed, "dRandGetSeed")());
}

TEST_P(MatrixDebug, ClearsTheUpperTriangleAsDebian) {
    const int n = GetParam().columns;
    std::vector<dReal> own(n * n + 4 * n + 1, 1.5), other = own;
    dClearUpperTriangle(own.data(), n);
    debianOde::function(dClearUpperTriangle, "dClearUpperTriangle")(other.data(), n);
    EXPECT_EQ(own, other);
}

TEST_P(MatrixDebug, ComparesAsDebian) {
    const auto difference = debianOde::function(dMaxDifference, "dMaxDifference");
    const auto lower = debianOde::function(dMaxDifferenceLowerTriangle, "dMaxDifferenceLowerTriangle");
    Matrix a = random(1), b = random(2);
    const auto check = [&] {
        const dReal *A = a.numbers.data(), *B = b.numbers.data();
        EXPECT_EQ(dMaxDifference(A, B, a.rows, a.columns), difference(A, B, a.rows, a.columns));
        if (a.rows == a.columns) {
            EXPECT_EQ(dMaxDifferenceLowerTriangle(A, B, a.rows), lower(A, B, a.rows));
        }
    };
    check();
    for (int i = 0; i < a.rows * a.columns; ++i) {
        Matrix kept = a;
        a.at(i / a.columns, i % a.columns) = kNaN;
        check();
        a.at(i / a.columns, i % a.columns) = std::numeric_limits<dReal>::infinity();
        check();
        a = kept;
    }
}

TEST_P(MatrixDebug, PrintsAsDebian) {
    const Matrix matrix = random(4);
    using Print = void(const dReal *, int, int, const char *, std::FILE *);
    const auto printed = [&](Print *print) {
        char *text = nullptr;
        std::size_t size = 0;
        std::FILE *file = open_memstream(&text, &size);
        print(matrix.numbers.data(), matrix.rows, matrix.columns, "%10.4f ", file);
        std::fclose(file);
        std::string result(text, size);
        std::free(text);
        return result;
    };
    Print *const own = dPrintMatrix;
    EXPECT_EQ(printed(own), printed(debianOde::function(own, "dPrintMatrix")));
}

INSTANTIATE_TEST_SUITE_P(Sizes, MatrixDebug, testing::ValuesIn(kSizes), [](const auto &info) {
    return std::to_string(info.param.rows) + "x" + std::to_string(info.param.columns);
});

TEST(MatrixDebugVector, FillsAsDebian) {
    if (!debianOde::kSamePrecision) GTEST_SKIP() << "another dReal";
    const auto fill = debianOde::function(dMakeRandomVector, "dMakeRandomVector");
    debianOde::function(dRandSetSeed, "dRandSetSeed")(8);
    dRandSetSeed(8);
    for (const int n : {-1, 0, 1, 100}) {
        std::vector<dReal> own(101, 1), other(101, 1);
        dMakeRandomVector(own.data(), n, 0.3);
        fill(other.data(), n, 0.3);
        EXPECT_EQ(own, other) << n << " numbers";
    }
}

}  // namespace
