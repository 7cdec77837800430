#include "newton_equations.h"

#include "../../constraints/constants.h"

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

double component(const Vec<double>& v, int i) { return i == 0 ? v.x : i == 1 ? v.y : v.z; }

// m, of a box around all vertices; of one vertex alone, which has no size, a metre.
double extent(const State<double>& state) {
    Vec<double> low = state.position(0), high = low;
    for (int i = 1; i < state.count(); ++i) {
        const Vec<double> p = state.position(i);
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    const double size = length(high - low);
    return size > 0 ? size : 1;
}

// A soft constraint of one vertex, as the pull towards a target is: linear through the target,
// where C has a kink. Its multiplier is no unknown but C / a, and midpoint has C half way.
bool isPull(const Terms<double>& terms, int n) {
    const auto soft = [](double alpha) { return alpha > 0 && alpha < slack; };
    return terms.arity == 1 && soft(terms.above[n]) && soft(terms.below[n]);
}

}  // namespace

void NewtonEquations::number(const State<double>& state, std::size_t sets) {
    place_.assign(state.particles.size(), -1);
    for (std::size_t i = 0; i < place_.size(); ++i)
        if (state.particles[i].w > 0) {
            place_[i] = rows_;
            rows_ += 3;
        }
    sets_.resize(sets);
    size_ = extent(state);
    y_.resize(place_.size());
    left_.resize(place_.size());
    gross_.resize(place_.size());
}

void NewtonEquations::begin(WholeSubstep<double>& s, bool cold) {
    State<double>& state = s.state;
    if (place_.empty()) number(state, s.sets.size());
    inverseH2_ = (midpoint_ ? 2 : 1) / (s.implied * s.implied);
    const Unknowns predicted = unknowns(state);
    for (std::size_t i = 0; i < place_.size(); ++i) {
        const Vec<double> before = state.before[i].v;
        const bool mean = midpoint_ && place_[i] >= 0;
        y_[i] = mean ? before + (s.h / 2) * (state.lastVelocity[i].v + state.velocity[i].v)
                     : state.particles[i].d;
        state.particles[i].d = before;
    }
    int count = 0;
    for (std::size_t k = 0; k < sets_.size(); ++k) {
        Set& set = sets_[k];
        s.sets[k]->terms(state, false, set.force);
        set.first = set.force.value;
        set.offset = count;
        count += set.force.size();
    }
    lambda_.resize(static_cast<std::size_t>(count), 0);
    multipliers_.resize(lambda_.size());
    if (cold) std::fill(lambda_.begin(), lambda_.end(), 0);
    for (std::size_t i = 0; i < place_.size(); ++i)
        if (!cold || place_[i] < 0) state.particles[i].d = predicted.d[i];
}

void NewtonEquations::evaluateSets(WholeSubstep<double>& s) {
    State<double>& state = s.state;
    for (std::size_t k = 0; k < sets_.size(); ++k)
        s.sets[k]->terms(state, !midpoint_, midpoint_ ? sets_[k].end : sets_[k].force);
    if (!midpoint_) return;
    const Unknowns end = unknowns(state);
    for (std::size_t i = 0; i < place_.size(); ++i)
        state.particles[i].d = 0.5 * (state.before[i].v + end.d[i]);
    for (std::size_t k = 0; k < sets_.size(); ++k) s.sets[k]->terms(state, true, sets_[k].force);
    for (std::size_t i = 0; i < place_.size(); ++i) state.particles[i].d = end.d[i];
}

long NewtonEquations::evaluate(WholeSubstep<double>& s, double softness) {
    evaluateSets(s);
    for (std::size_t i = 0; i < place_.size(); ++i) {
        const Particle<double>& p = s.state.particles[i];
        left_[i] = {};
        if (place_[i] >= 0) left_[i] = (1 / p.w) * (p.d - y_[i]);
        gross_[i] = length(left_[i]);
    }
    for (const Set& set : sets_)
        for (int n = 0; n < set.force.size(); ++n) judge(set, s.state, n, softness);
    return static_cast<long>(lambda_.size()) * (midpoint_ ? 2 : 1);
}

void NewtonEquations::judge(const Set& set, const State<double>& state, int n, double softness) {
    const Terms<double>&force = set.force, &end = endOf(set);
    double& lambda = lambda_[set.offset + n];
    Multiplier& m = multipliers_[set.offset + n];
    m.weight = 0;
    for (int a = end.arity * n; a < end.arity * (n + 1); ++a)
        m.weight += state.particles[end.ids[a]].w * dot(end.gradient[a], end.gradient[a]);
    const double without = end.value[n] + m.weight * lambda;
    const double alpha = without > 0 ? end.above[n] : end.below[n];
    m.acts = alpha < slack && m.weight > 0;
    m.compliance = (midpoint_ ? 2 : 1) * alpha * inverseH2_ + softness * m.weight;
    double value = end.value[n];
    const bool pull = isPull(end, n);
    if (midpoint_ && alpha > 0) value = pull ? 2 * force.value[n] : value + set.first[n];
    if (pull) lambda = value / m.compliance;
    m.left = m.acts ? value - m.compliance * lambda : -m.weight * lambda;
    for (int a = end.arity * n; a < end.arity * (n + 1); ++a) {
        if (place_[end.ids[a]] < 0) continue;
        const Vec<double> f = lambda * force.gradient[a];
        left_[end.ids[a]] += f;
        gross_[end.ids[a]] += length(f);
    }
}

void NewtonEquations::linearise(const State<double>& state, Matrix& matrix, Vector& right) {
    const int all = rows_ + static_cast<int>(lambda_.size());
    right.resize(all);
    entries_.clear();
    addMasses(state, right);
    for (const Set& set : sets_)
        for (int n = 0; n < set.force.size(); ++n) {
            addConstraint(set, state, n, right);
            addCurvature(set, state, n);
        }
    matrix.resize(all, all);
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    from_ = unknowns(state);
}

void NewtonEquations::addMasses(const State<double>& state, Vector& right) {
    for (std::size_t i = 0; i < place_.size(); ++i) {
        if (place_[i] < 0) continue;
        const double w = state.particles[i].w, mass = 1 / w, root = std::sqrt(w);
        for (int a = 0; a < 3; ++a) {
            entries_.emplace_back(place_[i] + a, place_[i] + a, w * mass);
            right[place_[i] + a] = -root * component(left_[i], a);
        }
    }
}

// What does not act loses its multiplier; its place in the matrix stays, as zeros.
void NewtonEquations::addConstraint(const Set& set, const State<double>& state, int n,
                                    Vector& right) {
    const Terms<double>&force = set.force, &end = isPull(endOf(set), n) ? force : endOf(set);
    const int c = set.offset + n, row = rows_ + c;
    Multiplier& m = multipliers_[c];
    // Of a matrix that is all but singular, as that of a flat sheet is, this keeps the factors
    // bounded; the equations are those without it.
    constexpr double floor = 1e-13;
    m.scale = m.weight > 0 ? 1 / std::sqrt(m.weight + (m.acts ? m.compliance : 0)) : 1;
    const double diagonal = m.acts ? m.scale * m.scale * m.compliance + floor : 1;
    entries_.emplace_back(row, row, -diagonal);
    right[row] = m.acts ? -m.scale * m.left : lambda_[c] / m.scale;
    for (int a = force.arity * n; a < force.arity * (n + 1); ++a) {
        const int v = force.ids[a], first = place_[v];
        if (first < 0) continue;
        const double root = std::sqrt(state.particles[v].w), factor = m.acts ? m.scale * root : 0;
        for (int i = 0; i < 3; ++i) {
            const double pull = component(force.gradient[a], i);
            entries_.emplace_back(first + i, row, factor * pull);
            entries_.emplace_back(row, first + i, factor * component(end.gradient[a], i));
            if (!m.acts) right[first + i] += root * lambda_[c] * pull;
        }
    }
}

void NewtonEquations::addCurvature(const Set& set, const State<double>& state, int n) {
    const Terms<double>& force = set.force;
    const int c = set.offset + n, arity = force.arity, numbers = 3 * arity;
    const double lambda = multipliers_[c].acts ? lambda_[c] * (midpoint_ ? 0.5 : 1) : 0;
    const double* const curvature = &force.curvature[numbers * numbers * n];
    for (int row = 0; row < numbers; ++row)
        for (int column = 0; column < numbers; ++column) {
            const int v = force.ids[arity * n + row / 3], u = force.ids[arity * n + column / 3];
            if (place_[v] < 0 || place_[u] < 0) continue;
            const double roots = std::sqrt(state.particles[v].w * state.particles[u].w);
            entries_.emplace_back(place_[v] + row % 3, place_[u] + column % 3,
                                  lambda * roots * curvature[numbers * row + column]);
        }
}

void NewtonEquations::move(State<double>& state, const Vector& solution, double part) {
    for (std::size_t i = 0; i < place_.size(); ++i) {
        if (place_[i] < 0) continue;
        Particle<double>& p = state.particles[i];
        const double* const u = &solution[place_[i]];
        p.d = from_.d[i] + (part * std::sqrt(p.w)) * Vec<double>{u[0], u[1], u[2]};
    }
    for (std::size_t c = 0; c < lambda_.size(); ++c)
        lambda_[c] =
            from_.lambda[c] + part * multipliers_[c].scale * solution[rows_ + static_cast<int>(c)];
}

double NewtonEquations::merit(const State<double>& state) const {
    double sum = 0;
    for (std::size_t i = 0; i < place_.size(); ++i)
        sum += state.particles[i].w * dot(left_[i], left_[i]);
    for (const Multiplier& m : multipliers_) sum += m.scale * m.scale * m.left * m.left;
    return sum;
}

double NewtonEquations::unbalanced(const State<double>& state) const {
    constexpr double rounding = 2.3e-16;
    double left = 0, gross = 0;
    for (std::size_t i = 0; i < left_.size(); ++i) {
        if (place_[i] < 0) continue;
        const Particle<double>& p = state.particles[i];
        left = std::max(left, length(left_[i]) - rounding * length(p.d) / p.w);
        gross = std::max(gross, gross_[i]);
    }
    return divide(left, gross);
}

double NewtonEquations::apart() const {
    double most = 0;
    for (const Set& set : sets_) {
        const Terms<double>& end = endOf(set);
        for (int n = 0; n < end.size(); ++n) {
            double slope = 0;
            for (int a = end.arity * n; a < end.arity * (n + 1); ++a)
                slope = std::max(slope, length(end.gradient[a]));
            most = std::max(most, divide(std::fabs(multipliers_[set.offset + n].left), slope));
        }
    }
    return most / size_;
}

bool NewtonEquations::solved(const State<double>& state, double tolerance) const {
    return unbalanced(state) <= tolerance && apart() <= tolerance / 1000;
}

bool NewtonEquations::rounded(const State<double>& state) const {
    double most = apart();
    for (std::size_t i = 0; i < left_.size(); ++i)
        most = std::max(most, state.particles[i].w * length(left_[i]) / size_);
    return most <= 1e-14;
}

NewtonEquations::Unknowns NewtonEquations::unknowns(const State<double>& state) const {
    Unknowns all{{}, lambda_};
    for (const Particle<double>& p : state.particles) all.d.push_back(p.d);
    return all;
}

void NewtonEquations::restore(State<double>& state, const Unknowns& all) {
    for (std::size_t i = 0; i < all.d.size(); ++i) state.particles[i].d = all.d[i];
    lambda_ = all.lambda;
}

}  // namespace plait
