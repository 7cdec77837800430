#include "certificate.h"

#include "demos/tools/files.h"
#include "demos/tools/interrupt.h"
#include "demos/tools/progress.h"
#include "demos/tools/web_page.h"
#include "demos/tools/words.h"

#include <cmath>
#include <cstdio>

namespace plait {
namespace {

constexpr double within = 0.02;

std::string percent(double value) {
    if (!std::isfinite(value)) return "does not rest";
    char word[32];
    std::snprintf(word, sizeof word, "%+.2f %%", 100 * value);
    return word;
}

bool small(double value) { return std::isfinite(value) && std::fabs(value) <= within; }

}  // namespace

bool CertificateRow::independent() const {
    return small(error) && small(iterations) && small(substeps) && small(triangles.value_or(0));
}

CertificateRow certify(const CertificateCase& c) {
    const double start = c.deflection(c.base);
    const auto change = [&](int substeps, int iterations, int refinement) {
        return c.deflection({substeps * c.base.substeps, iterations * c.base.iterations,
                             refinement * c.base.refinement}) /
                   start -
               1;
    };
    CertificateRow row{c.kind, c.load, start / c.exact - 1, change(1, 8, 1), change(8, 1, 1), {}};
    if (c.meshed) row.triangles = change(1, 1, 4);
    return row;
}

Table certificateTable(const std::vector<CertificateRow>& rows) {
    Table table{{"kind", "error", "x8 iterations", "x8 substeps", "x16 triangles", "independent",
                 "against"}};
    for (const CertificateRow& row : rows)
        table.push_back({row.kind, percent(row.error), percent(row.iterations),
                         percent(row.substeps), row.triangles ? percent(*row.triangles) : "-",
                         row.independent() ? "yes" : "NO", row.load});
    return table;
}

void writeCertificate(const std::filesystem::path& folder, bool quiet) {
    makeFolder(folder);
    const std::vector<CertificateCase>& cases = certificateCases();
    std::vector<CertificateRow> rows;
    Progress progress("study certificate", 0, static_cast<int>(cases.size()), quiet, "kinds");
    std::string csv = "kind,error,iterations,substeps,triangles,independent,against\n";
    for (const CertificateCase& c : cases) {
        stopIfInterrupted();
        const CertificateRow row = certify(c);
        rows.push_back(row);
        csv += "\"" + row.kind + "\"," + text(row.error) + "," + text(row.iterations) + "," +
               text(row.substeps) + "," + (row.triangles ? text(*row.triangles) : "") + "," +
               (row.independent() ? "yes" : "no") + ",\"" + row.load + "\"\n";
        progress.show(static_cast<int>(rows.size()));
    }
    const Table table = certificateTable(rows);
    writeWhole(folder / "certificate.csv", csv);
    writeWhole(folder / "index.html",
               webPage(certificateTitle,
                       "<p>The deflection at rest against its closed form, and how it "
                       "changes with 8 times the iterations, 8 times the substeps and 16 "
                       "times the triangles (4 times the links). Independent: all within "
                       "2 %.</p>\n" +
                           htmlOf(table) + commandLines("build/plait study certificate")));
    if (!quiet) std::printf("%s\n%s\n", textOf(table).c_str(), (folder / "index.html").c_str());
}

}  // namespace plait
