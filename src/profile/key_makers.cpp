#include <algorithm>
#include <utility>

#include "key.h"

namespace fusee::profile {

namespace {

Key plain(std::string path, Kind kind, std::string meaning) {
    Key key;
    key.path = std::move(path);
    key.kind = kind;
    key.meaning = std::move(meaning);
    return key;
}

/// The member as a value of the same type, or, of a path, as its text. `at` only finds it: the profile may be const.
template <class T, class Member>
Key of_member(std::string path, Kind kind, std::string meaning, At<Member> at) {
    Key key = plain(std::move(path), kind, std::move(meaning));
    key.get = [at](const Profile& p) { return Value(T(at(const_cast<Profile&>(p)))); };
    key.set = [at](Profile& p, const Value& v) { at(p) = std::get<T>(v); };
    return key;
}

template <class T>
Key limited(std::string path, Kind kind, Unit unit, Limits limits, std::string meaning, At<T> at) {
    Key key = of_member<T>(std::move(path), kind, std::move(meaning), std::move(at));
    key.unit = unit;
    key.limits = limits;
    return key;
}

}  // namespace

Key name_key(std::string path, std::string meaning, At<std::string> at) {
    return of_member<std::string>(std::move(path), Kind::kName, std::move(meaning), std::move(at));
}

Key file(std::string path, std::string meaning, At<std::filesystem::path> at) {
    return of_member<std::string>(std::move(path), Kind::kFile, std::move(meaning), std::move(at));
}

Key formula(std::string path, std::string meaning, At<std::string> at) {
    return of_member<std::string>(std::move(path), Kind::kFormula, std::move(meaning), std::move(at));
}

Key text_line(std::string path, std::string meaning, At<std::string> at) {
    return of_member<std::string>(std::move(path), Kind::kText, std::move(meaning), std::move(at));
}

Key number(std::string path, Unit unit, Limits limits, std::string meaning, At<double> at) {
    return limited(std::move(path), Kind::kNumber, unit, limits, std::move(meaning), std::move(at));
}

Key integer(std::string path, Limits limits, std::string meaning, At<int> at) {
    return limited(std::move(path), Kind::kInteger, kPure, limits, std::move(meaning), std::move(at));
}

Key sign(std::string path, std::string meaning, At<int> at) {
    return of_member<int>(std::move(path), Kind::kSign, std::move(meaning), std::move(at));
}

Key yes_or_no(std::string path, std::string meaning, At<bool> at) {
    return of_member<bool>(std::move(path), Kind::kSwitch, std::move(meaning), std::move(at));
}

Key numbers(std::string path, Unit unit, Limits limits, std::size_t least, std::size_t most, std::string meaning,
            At<std::vector<double>> at) {
    Key key = limited(std::move(path), Kind::kNumbers, unit, limits, std::move(meaning), std::move(at));
    key.least_count = least;
    key.most_count = most;
    return key;
}

Key range(std::string path, Unit unit, Limits limits, std::string meaning, At<core::Range> at) {
    Key key = plain(std::move(path), Kind::kNumbers, std::move(meaning));
    key.unit = unit;
    key.limits = limits;
    key.least_count = key.most_count = 2;
    key.get = [at](const Profile& p) {
        const core::Range& ends = at(const_cast<Profile&>(p));
        return Value(std::vector<double>{ends.low, ends.high});
    };
    key.set = [at](Profile& p, const Value& v) {
        const auto& ends = std::get<std::vector<double>>(v);
        at(p) = {ends[0], ends[1]};
    };
    return key;
}

Key choice(std::string path, std::vector<std::string> names, std::string meaning, At<std::string> at) {
    Key key = of_member<std::string>(std::move(path), Kind::kChoice, std::move(meaning), std::move(at));
    key.choices = std::move(names);
    return key;
}

Key choice(std::string path, std::vector<std::string> names, std::string meaning, std::function<std::size_t(Profile&)> get,
           std::function<void(Profile&, std::size_t)> set) {
    Key key = plain(std::move(path), Kind::kChoice, std::move(meaning));
    key.get = [names, get](const Profile& p) { return Value(names.at(get(const_cast<Profile&>(p)))); };
    key.set = [names, set](Profile& p, const Value& v) {
        set(p, static_cast<std::size_t>(std::find(names.begin(), names.end(), std::get<std::string>(v)) - names.begin()));
    };
    key.choices = std::move(names);
    return key;
}

}  // namespace fusee::profile
