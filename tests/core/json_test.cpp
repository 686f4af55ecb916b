#include "fusee/core/json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "refused.h"

// Third-party JSON: errors name their place.
namespace fusee::core {
namespace {

std::string json_refusal(const std::string& json) {
    try {
        (void)parse_json(json, "d.json");
    } catch (const InvalidInput& e) {
        return e.what();
    }
    return "accepted";
}

TEST(ParseJson, GivesWhatStandsThere) {
    const nlohmann::ordered_json json = parse_json(R"({"b": [1, -2.5e3, "}]"], "a": null})", "d.json");
    EXPECT_EQ(json["b"][1], -2500.0);
    EXPECT_EQ(json["b"][2], "}]");
    EXPECT_EQ(json.begin().key(), "b");
}

TEST(ParseJson, RefusalsNameTheLineAndTheColumn) {
    EXPECT_EQ(json_refusal("{\n \"a\": ]\n}"), "d.json:2:7: JSON: not valid JSON (allowed: JSON by RFC 8259)");
    EXPECT_NE(json_refusal("").find("d.json:1:1: JSON: not valid JSON"), std::string::npos);
    EXPECT_NE(json_refusal("{").find("d.json:1:2"), std::string::npos);
    EXPECT_EQ(json_refusal("{\"a\": 1,\n \"b\": 1e400}"), "d.json:2:7: JSON: 1e400 (allowed: a number of at most 1.798e+308)");
    EXPECT_NE(json_refusal("[-1e999]").find("d.json:1:2: JSON: -1e999"), std::string::npos);
    EXPECT_NE(json_refusal("[NaN]").find("not valid JSON"), std::string::npos);
}

TEST(ParseJson, DepthIsBounded) {
    const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
    EXPECT_EQ(json_refusal(nested(kDeepestJson)), "accepted");
    EXPECT_EQ(json_refusal(nested(kDeepestJson + 1)), "d.json:1:65: JSON: nested 65 deep or more (allowed: at most 64 deep)");
    EXPECT_NE(json_refusal(nested(100'000)).find("nested"), std::string::npos);
    EXPECT_NE(json_refusal(std::string(100'000, '[')).find("nested"), std::string::npos);
    EXPECT_EQ(json_refusal("\"" + std::string(1000, '[') + "\\\"" + std::string(1000, '{') + "\""), "accepted");
}

TEST(JsonNode, NamesTheKeyOfWhatItRefuses) {
    const nlohmann::ordered_json json = parse_json(R"({"a": [{"b": 3}], "n": null, "t": "x"})", "d.json");
    const JsonNode root(json, "d.json: top");
    EXPECT_EQ(root["a"].cells()[0]["b"].number(), 3.0);
    EXPECT_TRUE(std::isnan(root["n"].number_or_null()));
    EXPECT_EQ(root["t"].text(), "x");
    EXPECT_FALSE(root.has("z"));
    EXPECT_EQ(field_refused([&] { return root["z"]; }), "d.json: top.z");
    EXPECT_EQ(field_refused([&] { return root["a"].cells()[0]["b"].text(); }), "d.json: top.a[0].b");
    EXPECT_EQ(field_refused([&] { return root["a"].cells()[0]["b"].number_within(0, 2); }), "d.json: top.a[0].b");
    EXPECT_EQ(field_refused([&] { return root["t"].number(); }), "d.json: top.t");
    EXPECT_EQ(field_refused([&] { return root["t"].cells(); }), "d.json: top.t");
    EXPECT_EQ(field_refused([&] { return root["a"].members(); }), "d.json: top.a");
    EXPECT_EQ(field_refused([&] {
                  root.allow_keys({"a", "n"});
                  return 0;
              }),
              "d.json: top.t");
}

TEST(JsonNode, ReadsSignsCountsWordsAndVectors) {
    const nlohmann::ordered_json json = parse_json(R"({"s": -1, "n": 3, "t": "x", "v": [1, 2], "e": []})", "d.json");
    const JsonNode root = JsonNode::of_file(json, "d.json");
    EXPECT_EQ(root["s"].sign(), -1);
    EXPECT_EQ(root["n"].count(), 3u);
    EXPECT_EQ(root["n"].number_at_least(3.0), 3.0);
    EXPECT_EQ(root["t"].one_of({"x", "y"}), "x");
    EXPECT_EQ(root["v"].vector<2>(), (std::array{1.0, 2.0}));
    EXPECT_TRUE(root["e"].cells().empty());
    EXPECT_EQ(field_refused([&] { return root["n"].sign(); }), "d.json: n");
    EXPECT_EQ(field_refused([&] { return root["s"].count(); }), "d.json: s");
    EXPECT_EQ(field_refused([&] { return root["n"].number_at_least(4.0); }), "d.json: n");
    EXPECT_EQ(field_refused([&] { return root["t"].one_of({"y"}); }), "d.json: t");
    EXPECT_EQ(field_refused([&] { return root["v"].vector<3>(); }), "d.json: v");
    EXPECT_EQ(field_refused([&] { return root["e"].cells(1); }), "d.json: e");
    EXPECT_EQ(field_refused([&] { return root["z"]; }), "d.json: z");
}

TEST(JsonNode, ALongValueIsShortened) {
    const nlohmann::ordered_json json = nlohmann::ordered_json(std::string(100'000, 'x'));
    try {
        (void)JsonNode(json, "d.json").number();
        FAIL();
    } catch (const InvalidInput& e) {
        EXPECT_EQ(e.value().size(), 83u);
    }
}

TEST(Json, RenamedFieldsKeepTheirOldSpelling) {
    nlohmann::ordered_json json = parse_json(R"({"a": {"new": 1}, "rows": [{"new": 2}, {"other": 3}]})", "d.json");
    keep_old_spelling(json, {{"old", "new"}, {"gone", "absent"}});
    EXPECT_EQ(json["a"]["old"], 1);
    EXPECT_EQ(json["rows"][0]["old"], 2);
    EXPECT_FALSE(json["rows"][1].contains("old"));
    EXPECT_EQ(json["renamed_fields"], nlohmann::ordered_json({{"old", "new"}}));
}

}  // namespace
}  // namespace fusee::core
