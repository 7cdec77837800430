// Which kinds are as stiff as they are told to be, however they are solved.
#include "demos/study/pages/certificate.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <algorithm>
#include <cmath>

using namespace plait;
using plait::test::report;

namespace {

CertificateRow certified(const std::string& kind) {
    for (const CertificateCase& c : certificateCases())
        if (c.kind == kind) return certify(c);
    FAIL("no kind " + kind);
    return {};
}

void checkIndependent(const std::string& kind) {
    const CertificateRow row = certified(kind);
    CHECK(row.independent());
    CHECK(report(kind + ": error", std::fabs(row.error), 0.02));
    CHECK(report(kind + ": change with 8 times the iterations", std::fabs(row.iterations), 0.02));
    CHECK(report(kind + ": change with 8 times the substeps", std::fabs(row.substeps), 0.02));
    CHECK(report(kind + ": change with 16 times the triangles",
                 std::fabs(row.triangles.value_or(0)), 0.02));
}

}  // namespace

TEST_CASE("certificate: these kinds are independent of how they are solved",
          "[certificate][DC2][DC12]") {
    for (const std::string kind : {"attach", "stretch", "shear", "angle, of corners"})
        checkIndependent(kind);
}

TEST_CASE("certificate: a rod bends alike however it is solved", "[certificate][long]") {
    checkIndependent("angle, of a rod");
}

TEST_CASE("certificate: and nucleus is not", "[certificate]") {
    const CertificateRow row = certified("stretch, by nucleus");
    CHECK_FALSE(row.independent());
    CHECK(std::fabs(row.iterations) > 0.5);
    CHECK(std::fabs(row.substeps) > 0.5);
}

TEST_CASE("certificate: one failure is enough", "[certificate]") {
    const CertificateRow good{"a", "b", 0.01, -0.01, 0.01, 0.01};
    CHECK(good.independent());
    for (double CertificateRow::* part :
         {&CertificateRow::error, &CertificateRow::iterations, &CertificateRow::substeps}) {
        CertificateRow bad = good;
        bad.*part = -0.03;
        CHECK_FALSE(bad.independent());
        bad.*part = std::nan("");
        CHECK_FALSE(bad.independent());
    }
    CertificateRow bad = good;
    bad.triangles = 0.03;
    CHECK_FALSE(bad.independent());
    bad.triangles.reset();
    CHECK(bad.independent());
}
