#include "sample.h"

#include <boost/random/sobol.hpp>
#include <cmath>
#include <numeric>
#include <random>

namespace fusee::study {

namespace {

double uniform(std::mt19937_64& random) { return std::ldexp(static_cast<double>(random() >> 11), -53); }

std::mt19937_64 generator(std::uint64_t seed, std::size_t stream) {
    const auto low = [](std::uint64_t x) { return static_cast<std::uint32_t>(x); };
    std::seed_seq words{low(seed), low(seed >> 32), low(stream), low(stream >> 32)};
    return std::mt19937_64(words);
}

class Random final : public Sample {
public:
    Random(std::size_t dimensions, std::uint64_t seed) : dimensions_(dimensions), seed_(seed) {}
    [[nodiscard]] std::vector<double> point(std::size_t index) const override {
        std::mt19937_64 random = generator(seed_, index);
        std::vector<double> x(dimensions_);
        for (double& one : x) one = uniform(random);
        return x;
    }

private:
    std::size_t dimensions_;
    std::uint64_t seed_;
};

/// McKay, Beckman and Conover 1979: one random permutation of the intervals for each key, and a random place inside the interval.
class LatinHypercube final : public Sample {
public:
    LatinHypercube(std::size_t dimensions, std::size_t count, std::uint64_t seed) : places_(dimensions, seed), orders_(dimensions) {
        for (std::size_t key = 0; key < dimensions; ++key) {
            std::vector<std::uint32_t>& order = orders_[key];
            order.resize(count);
            std::iota(order.begin(), order.end(), 0U);
            std::mt19937_64 random = generator(~seed, key);
            for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random() % i]);  // Fisher and Yates
        }
    }
    [[nodiscard]] std::vector<double> point(std::size_t index) const override {
        std::vector<double> x = places_.point(index);
        for (std::size_t key = 0; key < x.size(); ++key) x[key] = (orders_[key][index] + x[key]) / static_cast<double>(orders_[key].size());
        return x;
    }

private:
    Random places_;
    std::vector<std::vector<std::uint32_t>> orders_;
};

class Sobol final : public Sample {
public:
    explicit Sobol(std::size_t dimensions) : dimensions_(dimensions) {}
    [[nodiscard]] std::vector<double> point(std::size_t index) const override {
        boost::random::sobol sequence(dimensions_);
        sequence.discard(index * dimensions_);
        std::vector<double> x(dimensions_);
        for (double& one : x) one = std::ldexp(static_cast<double>(sequence() >> 11), -53);
        return x;
    }

private:
    std::size_t dimensions_;
};

}  // namespace

std::unique_ptr<Sample> make_sample(Method method, std::size_t dimensions, std::size_t count, std::uint64_t seed) {
    if (method == Method::kSobol) return std::make_unique<Sobol>(dimensions);
    if (method == Method::kLatinHypercube) return std::make_unique<LatinHypercube>(dimensions, count, seed);
    return std::make_unique<Random>(dimensions, seed);
}

}  // namespace fusee::study
