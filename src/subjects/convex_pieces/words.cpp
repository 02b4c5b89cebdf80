#include <fmt/format.h>

#include <array>

#include "subjects/convex_pieces/shown.hpp"

namespace gjkscope::parts {
namespace {

void triangle(const Shown& shown, FrameText& text) {
  const LessonShape& shape = shown.shape(shown.step->of_x);
  const auto& triangles = shown.trace.of(shown.step->of_x).triangles;
  const std::string name = corners_name(shape, triangles[shown.step->index]);
  if (shown.step->index + 1 == static_cast<int>(triangles.size())) {
    text.caption = fmt::format("Triangle {} is what is left of {}.", name, shape.name);
    text.detail = fmt::format("{} is cut into {} triangles. A polygon with n corners gives n − 2.",
                              shape.name, triangles.size());
    return;
  }
  text.caption = fmt::format("Triangle {} is an ear of {}: cut it off.", name, shape.name);
  text.detail =
      "An ear is made of three corners in a row of what is left. It lies in there, and no other "
      "corner "
      "lies in it.";
}

void merge(const Shown& shown, FrameText& text) {
  const LessonShape& shape = shown.shape(shown.step->of_x);
  const models::Merge& merge = shown.trace.of(shown.step->of_x).merges[shown.step->index];
  const std::string name = corners_name(shape, std::array{merge.from, merge.to});
  if (merge.merged) {
    text.caption = fmt::format("Diagonal {} goes: its two pieces become one.", name);
    text.detail = "At both ends the piece still turns one way only, so it is convex.";
  } else {
    text.caption = fmt::format("Diagonal {} stays.", name);
    text.detail = "Without it a piece would have a corner that turns in.";
  }
}

void fewest(const Shown& shown, FrameText& text) {
  const std::size_t found = shown.trace.of(shown.step->of_x).pieces.size();
  const std::size_t fewest = shown.trace.fewest_of(shown.step->of_x).size();
  text.caption = fmt::format("{} pieces were found; the wide cuts leave only {}.", found, fewest);
  text.detail =
      "Hertel and Mehlhorn approximate: at most 4 times the fewest. With holes, and of solids, the "
      "fewest are NP-hard to find.";
}

void pair(const Story& story, const Shown& shown, FrameText& text) {
  const models::PieceRun& run = shown.run();
  const std::string x = shown.piece(true, run.a);
  const std::string y = shown.piece(false, run.b);
  const models::PieceRun* least = shown.least(shown.step->index);
  if (run.skipped) {
    text.caption =
        fmt::format("Skip {} and {}: their boxes are {} apart.", x, y, story.numbers(run.bound));
    text.detail =
        fmt::format("δ is {}. Pieces are never closer than their boxes, so this pair cannot win.",
                    story.numbers(least->distance));
    return;
  }
  text.caption = fmt::format("GJK: {} and {} are {} apart.", x, y, story.numbers(run.distance));
  if (least == nullptr) {
    text.detail = "This is the first pair, so δ is its distance.";
  } else if (run.distance < least->distance) {
    text.detail = fmt::format("That is less than {}, so δ falls.", story.numbers(least->distance));
  } else {
    text.detail = fmt::format("That is not less than δ = {}.", story.numbers(least->distance));
  }
}

void ask_for_an_ear(const Shown& shown, const PiecesStep& step, FrameText& text) {
  const LessonShape& shape = shown.shape(step.of_x);
  const auto name = [&](int corner) { return shape.vertex_names[corner]; };
  FrameQuestion& asked = text.question.emplace(FrameQuestion{std::string(kAskEar.name), {}, {}});
  for (const int corner : shown.tip_and_no_ears(step)) asked.choices.push_back(name(corner));
  asked.answer = name(shown.trace.of(step.of_x).triangles[step.index][1]);
  asked.refuted = "At the others what is left turns in, or another corner lies in the triangle.";
  text.caption = fmt::format(
      "Question: at which of these corners is an ear of {}, to be cut off next? Point at it.",
      shape.name);
}

void ask_for_fewest(const Shown& shown, const PiecesStep& step, FrameText& text) {
  const LessonShape& shape = shown.shape(step.of_x);
  const std::size_t found = shown.trace.of(step.of_x).pieces.size();
  const std::size_t fewest = shown.trace.fewest_of(step.of_x).size();
  FrameQuestion& asked = text.question.emplace(FrameQuestion{std::string(kAskFewest.name), {}, {}});
  for (std::size_t count = 2; count <= found; ++count)
    asked.choices.push_back(fmt::format("{} pieces", count));
  asked.answer = fmt::format("{} pieces", fewest);
  const std::size_t corners = shown.trace.turning_in[step.of_x ? 0 : 1].size();
  const std::size_t cuts = (corners + 1) / 2;
  asked.refuted = fmt::format(
      "{} corners turn in, and a cut mends two at most: {} cuts, and {} pieces, are the least.",
      corners, cuts, cuts + 1);
  text.caption = fmt::format(
      "Question: {} was cut into {} pieces. Into how few convex pieces can it be cut? A cut leads "
      "from "
      "corner to corner.",
      shape.name, found);
}

}  // namespace

void words(const Story& story, FrameText& text) {
  const Shown& shown = shown_in<Shown>(story);
  if (shown.trace.refusal) {
    text.caption =
        fmt::format("Cutting does not take {}.", words_of(*shown.trace.refusal, shown.lesson));
    text.detail = "It needs closed outlines that do not meet themselves or each other.";
  } else if (shown.step == nullptr) {
    text.caption = "GJK needs convex shapes. The shapes are cut into convex pieces.";
    text.detail = "The distance is the least over all pairs of pieces.";
  } else if (shown.is_answer) {
    const models::PiecesAnswer& result = shown.trace.result;
    text.caption = fmt::format("{} and {} are {} apart.", shown.lesson.x().name,
                               shown.lesson.y().name, story.numbers(result.answer.distance));
    if (result.answer.overlap)
      text.caption =
          fmt::format("{} and {} overlap.", shown.lesson.x().name, shown.lesson.y().name);
    text.detail =
        fmt::format("{} and {} pieces make {} pairs. GJK ran on {}.", shown.trace.x.pieces.size(),
                    shown.trace.y.pieces.size(),
                    shown.trace.x.pieces.size() * shown.trace.y.pieces.size(), result.visits);
  } else if (shown.step->phase == PiecesPhase::triangle) {
    triangle(shown, text);
  } else if (shown.step->phase == PiecesPhase::merge) {
    merge(shown, text);
  } else if (shown.step->phase == PiecesPhase::fewest) {
    fewest(shown, text);
  } else {
    pair(story, shown, text);
  }
}

void question(const Story& story, FrameText& text) {
  const Shown& shown = shown_in<Shown>(story);
  const PiecesStep& step = shown.trace.all[story.frame.answering_step];
  if (step.phase == PiecesPhase::triangle) return ask_for_an_ear(shown, step, text);
  if (step.phase == PiecesPhase::fewest) return ask_for_fewest(shown, step, text);
  if (step.phase == PiecesPhase::merge) {
    const models::Merge& merge = shown.trace.of(step.of_x).merges[step.index];
    FrameQuestion& asked = text.question.emplace(
        FrameQuestion{std::string(kAskDiagonal.name),
                      {"it goes: the piece stays convex", "it stays: a corner would turn in"},
                      {}});
    asked.answer = asked.choices[merge.merged ? 0 : 1];
    text.caption =
        fmt::format("Question: can diagonal {} be taken away?",
                    corners_name(shown.shape(step.of_x), std::array{merge.from, merge.to}));
    return;
  }
  const models::PieceRun& run = shown.trace.result.runs[step.index];
  FrameQuestion& asked = text.question.emplace(FrameQuestion{
      std::string(kAskPair.name), {"run GJK", "skip: their boxes are too far apart"}, {}});
  asked.answer = asked.choices[run.skipped ? 1 : 0];
  text.caption = fmt::format("Question: {} and {}, run or skip?", shown.piece(true, run.a),
                             shown.piece(false, run.b));
}

void values(const Story& story, FrameText& text) {
  const Shown& shown = shown_in<Shown>(story);
  const auto put = [&](std::string name, std::string value) {
    text.values.emplace_back(std::move(name), std::move(value));
  };
  put("x", story.run.lesson.x().name);
  put("y", story.run.lesson.y().name);
  put("triangles", std::to_string(shown.over(PiecesPhase::triangle)));
  int runs = 0;
  for (int i = 0; i < shown.over(PiecesPhase::pair); ++i)
    runs += shown.trace.result.runs[i].skipped ? 0 : 1;
  put("runs", std::to_string(runs));
  if (shown.least() != nullptr) put("least", story.numbers(shown.least()->distance));
}

}  // namespace gjkscope::parts
