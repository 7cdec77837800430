// Formulas as MathML, which browsers set by themselves.
#pragma once

#include <string>

namespace plait {

// A formula in the few words of TeX that the catalogue needs: letters, numbers, operators, _ and ^,
// {groups}, \frac, \sqrt, \b{bold letter}, \text, \hat, \dot, \tilde, \sum, \prod, functions (\cos
// ...), Greek letters and signs by their names. `block`: a line of its own, and one
// more after each ", \quad"; else within a sentence.
// Throws std::invalid_argument, "formula: what is wrong", for a word that is not known and for
// groups that do not close.
std::string mathMl(const std::string& tex, bool block = true);

// Text between $ signs set as formulas within it; the rest is escaped.
std::string withFormulas(const std::string& text);

}  // namespace plait
