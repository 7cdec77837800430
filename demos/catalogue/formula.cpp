#include "formula.h"

#include "render/charts/chart.h"  // escaped

#include <cctype>
#include <map>
#include <stdexcept>
#include <vector>

namespace plait {
namespace {

const std::map<std::string, std::string> formulaLetters{
    {"alpha", "α"}, {"beta", "β"},  {"gamma", "γ"}, {"delta", "δ"},  {"epsilon", "ε"},
    {"eta", "η"},   {"theta", "θ"}, {"kappa", "κ"}, {"lambda", "λ"}, {"mu", "μ"},
    {"nu", "ν"},    {"pi", "π"},    {"rho", "ρ"},   {"sigma", "σ"},  {"tau", "τ"},
    {"phi", "φ"},   {"psi", "ψ"},   {"omega", "ω"}, {"Delta", "Δ"},  {"Gamma", "Γ"},
    {"Omega", "Ω"}, {"infty", "∞"}, {"ell", "ℓ"}};
const std::map<std::string, std::string> formulaSigns{
    {"cdot", "·"},    {"times", "×"}, {"le", "≤"},     {"ge", "≥"},        {"ne", "≠"},
    {"approx", "≈"},  {"to", "→"},    {"gets", "←"},   {"in", "∈"},        {"nabla", "∇"},
    {"partial", "∂"}, {"pm", "±"},    {"perp", "⊥"},   {"ldots", "…"},     {"parallel", "∥"},
    {"ll", "≪"},      {"gg", "≫"},    {"propto", "∝"}, {"quad", "\u2003"}, {"prime", "′"}};
const std::map<std::string, std::string> formulaAccents{
    {"hat", "^"}, {"dot", "˙"}, {"tilde", "~"}, {"bar", "¯"}};
const std::string formulaFunctions = " cos sin tan atan acos min max det exp log sign argmin lim ";

// A Latin letter in bold of the mathematical alphabets.
std::string boldLetter(char letter) {
    const int first = std::isupper(static_cast<unsigned char>(letter)) ? 0x1D400 + letter - 'A'
                                                                       : 0x1D41A + letter - 'a';
    return "&#" + std::to_string(first) + ";";
}

class FormulaReader {
public:
    explicit FormulaReader(std::string tex) : tex_(std::move(tex)) {}

    std::string whole() { return until('\0'); }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw std::invalid_argument("formula: " + what + " in " + tex_);
    }
    char peek() const { return at_ < tex_.size() ? tex_[at_] : '\0'; }
    void skip() {
        while (peek() == ' ') ++at_;
    }

    std::string until(char end) {
        std::string row;
        for (skip(); peek() != end; skip()) {
            if (peek() == '\0') fail("a group does not close");
            row += scripted();
        }
        if (end != '\0') ++at_;
        return "<mrow>" + row + "</mrow>";
    }

    // An atom with what stands below and above it.
    std::string scripted() {
        const std::size_t from = at_;
        std::string base = atom();
        const std::string word = tex_.substr(from, at_ - from);
        const bool limits = word.starts_with("\\sum") || word.starts_with("\\prod") ||
                            word.starts_with("\\min") || word.starts_with("\\argmin") ||
                            word.starts_with("\\lim");
        std::string below, above;
        for (skip(); peek() == '_' || peek() == '^'; skip()) {
            std::string& script = peek() == '_' ? below : above;
            if (!script.empty()) fail("two scripts at one place");
            ++at_;
            skip();
            script = atom();
        }
        if (below.empty() && above.empty()) return base;
        const std::string name = below.empty()   ? (limits ? "mover" : "msup")
                                 : above.empty() ? (limits ? "munder" : "msub")
                                                 : (limits ? "munderover" : "msubsup");
        return "<" + name + ">" + base + below + above + "</" + name + ">";
    }

    std::string atom() {
        const char c = peek();
        if (c == '\0') fail("something is missing");
        ++at_;
        if (c == '{') return until('}');
        if (c == '\\') return command();
        if (c == '}' || c == '_' || c == '^') fail(std::string("a lone ") + c);
        if (std::isdigit(static_cast<unsigned char>(c))) {
            std::string number(1, c);
            while (std::isdigit(static_cast<unsigned char>(peek())) || peek() == '.')
                number += tex_[at_++];
            return "<mn>" + number + "</mn>";
        }
        if (std::isalpha(static_cast<unsigned char>(c)))
            return "<mi>" + std::string(1, c) + "</mi>";
        if (c == '|') return R"(<mo stretchy="false" form="prefix">|</mo>)";
        if (c == '-') return "<mo>−</mo>";
        if (c == '\'') return "<mo>′</mo>";
        if (c == '(' || c == ')') return parenthesis(c);
        return "<mo>" + escaped(std::string(1, c)) + "</mo>";
    }

    // As high as what it holds where that has a fraction or a sum in it, else as a letter.
    std::string parenthesis(char c) {
        if (c == '(') {
            std::size_t end = at_;
            for (int open = 1; end < tex_.size() && open > 0; ++end)
                open += tex_[end] == '(' ? 1 : tex_[end] == ')' ? -1 : 0;
            const std::string inside = tex_.substr(at_, end - at_);
            high_.push_back(inside.find("\\frac") != std::string::npos ||
                            inside.find("\\sum") != std::string::npos);
        }
        if (high_.empty()) fail("a lone )");
        const bool high = high_.back();
        if (c == ')') high_.pop_back();
        return std::string("<mo") + (high ? ">" : " stretchy=\"false\">") + c + "</mo>";
    }

    std::string word() {
        std::string name;
        while (std::isalpha(static_cast<unsigned char>(peek()))) name += tex_[at_++];
        return name;
    }
    std::string argument() {
        skip();
        if (peek() != '{') fail("a { is missing");
        ++at_;
        return until('}');
    }
    std::string plain() {
        skip();
        if (peek() != '{') fail("a { is missing");
        const std::size_t end = tex_.find('}', at_);
        if (end == std::string::npos) fail("a group does not close");
        const std::string text = tex_.substr(at_ + 1, end - at_ - 1);
        at_ = end + 1;
        return text;
    }

    std::string command() {
        if (peek() == '|') {
            ++at_;
            return "<mo stretchy=\"false\" form=\"prefix\">‖</mo>";
        }
        const std::string name = word();
        if (name == "frac") {
            const std::string above = argument();
            return "<mfrac>" + above + argument() + "</mfrac>";
        }
        if (name == "sqrt") return "<msqrt>" + argument() + "</msqrt>";
        if (name == "text") return "<mtext>" + escaped(plain()) + "</mtext>";
        if (name == "b") {
            const std::string letter = plain();
            if (letter == "λ") return "<mi>&#x1D6CC;</mi>";
            if (letter == "ω") return "<mi>&#x1D6DA;</mi>";
            if (letter.size() != 1) fail("\\b takes one letter");
            return "<mi>" + boldLetter(letter[0]) + "</mi>";
        }
        if (name == "sum") return "<mo>∑</mo>";
        if (name == "prod") return "<mo>∏</mo>";
        if (const auto found = formulaAccents.find(name); found != formulaAccents.end())
            return "<mover accent=\"true\">" + argument() + "<mo>" + found->second +
                   "</mo></mover>";
        if (const auto found = formulaLetters.find(name); found != formulaLetters.end())
            return "<mi>" + found->second + "</mi>";
        if (const auto found = formulaSigns.find(name); found != formulaSigns.end())
            return "<mo>" + found->second + "</mo>";
        if (!name.empty() && formulaFunctions.find(" " + name + " ") != std::string::npos)
            return "<mrow><mi>" + name + "</mi><mspace width=\"0.15em\"></mspace></mrow>";
        fail("\\" + name + " is not known");
    }

    std::string tex_;
    std::size_t at_ = 0;
    std::vector<bool> high_;  // parentheses that are open
};

}  // namespace

std::string mathMl(const std::string& tex, bool block) {
    if (!block) return "<math>" + FormulaReader(tex).whole() + "</math>";
    // What stands side by side goes line by line: narrow screens have no room for more.
    const std::string between = ", \\quad";
    std::string lines;
    for (std::size_t from = 0, end = 0; end != std::string::npos; from = end + between.size()) {
        end = tex.find(between, from);
        const std::string line = tex.substr(from, end == std::string::npos ? end : end - from);
        lines += "<math display=\"block\">" + FormulaReader(line).whole() + "</math>";
    }
    return lines;
}

std::string withFormulas(const std::string& text) {
    std::string html;
    std::size_t from = 0;
    for (std::size_t dollar; (dollar = text.find('$', from)) != std::string::npos;) {
        const std::size_t end = text.find('$', dollar + 1);
        if (end == std::string::npos) throw std::invalid_argument("formula: a lone $ in " + text);
        html += escaped(text.substr(from, dollar - from)) +
                mathMl(text.substr(dollar + 1, end - dollar - 1), false);
        from = end + 1;
    }
    return html + escaped(text.substr(from));
}

}  // namespace plait
