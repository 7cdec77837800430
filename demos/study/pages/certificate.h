// The certificate: which kinds of constraint are as stiff as they are told to be, however they are
// solved. Each holds a load whose deflection at rest has a closed form, with the settings it begins
// with, with 8 times the iterations, with 8 times the substeps, and with 16 times the triangles (4
// times the links of a rope).
#pragma once

#include "demos/study/tables.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace plait {

inline constexpr const char* certificateTitle =
    "Which kinds are independent of how they are solved";

struct CertificateSolve {
    int substeps = 40;   // in 1/24 s
    int iterations = 4;  // in a substep
    int refinement = 1;  // of the mesh, along each edge
};

struct CertificateCase {
    std::string kind, load;
    double exact;        // of what is measured
    bool meshed = true;  // false: there is nothing to refine
    // What is measured once it rests; a number that is not finite where it does not come to rest.
    std::function<double(const CertificateSolve&)> deflection;
    CertificateSolve base = {};  // the settings that it begins with
};

const std::vector<CertificateCase>& certificateCases();

// In units of 1.
struct CertificateRow {
    std::string kind, load;
    double error;                     // against the closed form
    double iterations, substeps;      // change of the deflection
    std::optional<double> triangles;  // the same, where there is a mesh

    // All of them within 2 %.
    bool independent() const;
};

CertificateRow certify(const CertificateCase& c);

Table certificateTable(const std::vector<CertificateRow>& rows);

// All of it: prints the table and leaves certificate.csv and index.html in `folder`.
void writeCertificate(const std::filesystem::path& folder, bool quiet);

}  // namespace plait
