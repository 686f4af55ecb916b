#pragma once
#include <cstddef>

/// The constants of the engine of diagnosis: one table, with unit, meaning and reason. docs/theory (diagnosis.md, unknown.md) gives the
/// evidence of those that decide a verdict; a test compares both. Constants of a model (accuracy of its predictions, usual sizes of its
/// effects) stand with the model.
namespace fusee::inference {

// Residuals and loss (docs/theory/diagnosis.md, eq. 7 to 11)
inline constexpr double kEffectPrior = 3.0;  ///< one sigma of an effect's size, in its scale; three times the usual size is plausible
inline constexpr double kStep = 0.3;  ///< of a difference: in sigmas of a build parameter; wide enough to cross the corners of friction
inline constexpr double kEffectStep =
    0.04;  ///< of a difference: in scales of an effect's parameter; a size is known far better than its prior
inline constexpr double kHeldReach = 1.0;  ///< sigmas from where they were taken to which slopes of a simulator's figures hold; the fit of
                                           ///< such a distance ends in two or three steps more, each a prediction
inline constexpr double kCauchy = 3.0;     ///< sigma at which a residual begins to count less: c of the loss
inline constexpr double kFair = 1.5;       ///< T up to which the prediction of an experiment is as accurate as expected

// Fit and the spread of its predictions (eq. 8 to 12)
inline constexpr std::size_t kPairsOfDraws = 3;  ///< pairs of draws of the spread; six predictions, a limit of time
inline constexpr double kBuildDraw =
    0.7;  ///< size of a draw in sigmas of a build parameter; all are drawn at once, so each by less than one
inline constexpr double kEffectDraw = 0.03;  ///< of a draw, in shares of an effect's size or a ripple's count; about its final accuracy
inline constexpr double kFurtherDraw = 0.2;  ///< of a draw, in shares of its further parameters; known less well
inline constexpr int kLeastRounds = 2;       ///< of fits, each at the scales and slopes that the last one left
inline constexpr int kMostRounds = 6;        ///< the same, at most; of 40 faultless rigs all end before
inline constexpr double kSettled = 1.0;      ///< fall of the cost in a round that ends them: a change of the log evidence by 0.5

// Screening and search (eq. 13 and 14)
inline constexpr int kDirectRounds = 6;          ///< steps on direct experiments; starts, not results
inline constexpr double kDirectStep = 0.01;      ///< of the differences of such steps, in scales
inline constexpr double kDead = 1e-9;            ///< of a sigma: a size that changes no value by more does nothing
inline constexpr int kReaching = 8;              ///< halvings to where a limit begins to act, and sizes to try from there
inline constexpr double kLike = 0.05;            ///< distance, in x, of starts that are one
inline constexpr int kScreenRounds = 2;          ///< steps of a screening with the effect's own columns; a choice of time
inline constexpr std::size_t kRippleStarts = 3;  ///< counts of a ripple that are tried further
inline constexpr std::size_t kSingles = 5;       ///< single effects fitted in full; more than the members of a usual class
inline constexpr double kNearEnough = 0.5;  ///< of the way from the best back to no effect, within which a rival of what explains all is
                                            ///< fitted; full fits improve the screening by less
inline constexpr std::size_t kPairs = 3;    ///< hypotheses fitted with one effect more upon each base
inline constexpr std::size_t kBases =
    2;  ///< hypotheses upon which one effect more is sought; the first effect of a pair may resemble another one alone
inline constexpr std::size_t kMostEffects = 4;  ///< effects of a hypothesis; each costs as much as the pairs
inline constexpr std::size_t kRefined = 2;      ///< hypotheses that are searched again; the best one and its rival
inline constexpr double kWorthAPair =
    60.0;  ///< a base is left out when it is so far behind the best one; a second effect rarely compensates more [nats]
inline constexpr double kNeighbour = 1.5;       ///< factor of a further parameter from which a fit is started again
inline constexpr double kWorthARestart = 60.0;  ///< a smaller hypothesis is started again up to here behind; a local minimum cost 34 [nats]
inline constexpr double kNothingLeft = 1.15;    ///< T of every experiment at which no further effect is sought
inline constexpr double kStretched = 3.5;       ///< sigmas of a build parameter: among 25, one time in a hundred on a faultless rig
inline constexpr double kStrained = 3.0;        ///< sigmas of a build parameter beyond which it may replace the effect under test
inline constexpr double kMisstated = 4.0;       ///< sigmas of a build parameter beyond which its figure may be named as the cause
inline constexpr double kMisstatedOdds = 11.0;  ///< log odds that no effect loses then: the pull is half an effect by itself [nats]
inline constexpr double kLikeStrain = 0.5;      ///< share of a strain from which the other side's is the same cause
inline constexpr double kStandsOff = 3.0;       ///< sigmas from 0 that an effect's size has to stand
inline constexpr double kLeastSize = 0.1;       ///< of what is usual: less is what a law leaves open; not where that is a guess
inline constexpr double kEffectOdds = 15.0;  ///< log odds against an effect: some sixty candidates, and rigs are mostly as designed [nats]
inline constexpr double kSecondOdds =
    17.0;  ///< log odds against each further effect, which also tends to correct errors of the first law [nats]
inline constexpr double kOtherSideOdds =
    5.0;                                 ///< the same against an effect of the other side by another size: few causes have one side [nats]
inline constexpr double kUnequal = 0.2;  ///< of the larger size, by which such sizes differ
inline constexpr double kSidesDiffer =
    2.576;  ///< sigmas of the difference of the sizes of two sides, from which one size for both leaves a doubt: one rig of 100 by chance

// Experiments and rows left out, intervals (eq. 15 and 16)
inline constexpr int kFolds = 4;  ///< parts of the rows, each held out once
inline constexpr std::size_t kLeftOut =
    4;  ///< hypotheses of the ranking whose experiments are left out; the rest have negligible probability
inline constexpr double kContradicted = 30.0;  ///< against a hypothesis of which the experiments disagree about a size [nats]
inline constexpr double kWitness = 3.0;        ///< sigmas from 0 at which the experiments that are left would see a size
inline constexpr std::size_t kWitnesses = 3;   ///< refits that see a size, of which the scatter says something
inline constexpr double kStandOff = 1.5;       ///< half intervals from 0 that a size has to stand
inline constexpr double kAtEnd = 1e-6;         ///< of the allowed range; rounding
inline constexpr double kLawAccuracy = 0.01;   ///< of a size: what tables and steps of the model leave of it, one sigma
inline constexpr double kNormal95 = 1.959964;  ///< sigmas of 95 % of a normal distribution

// Generic terms (docs/theory/unknown.md)
inline constexpr double kTermOdds = 25.0;     ///< log odds against a generic term: each has more freedom than an effect [nats]
inline constexpr double kMuchLeft = 100.0;    ///< evidence that T of 1 everywhere would add, from which a single effect competes with every
                                              ///< term; wrong answers left 273 and more, most right ones 80 at most [nats]
inline constexpr std::size_t kImproved = 12;  ///< terms that make a step in the screening
inline constexpr std::size_t kFitted = 3;     ///< terms fitted in full
inline constexpr std::size_t kMostTerms = 2;  ///< generic terms of an answer
inline constexpr double kHalf = 0.5;          ///< share of its odds that one half of a term on both sides has to be worth alone

// Verdict
inline constexpr double kSure = 0.75;          ///< probability from which one hypothesis is the answer
inline constexpr double kRival = 0.08;         ///< least probability of an alternative that counts
inline constexpr double kImpossible = 5.0;     ///< sigmas that no workshop exceeds
inline constexpr double kSlip = 1.5;           ///< spread of a row that sticks and slips
inline constexpr double kSlips = 0.25;         ///< share of such rows from which an experiment is no evidence against the model
inline constexpr double kInMostCases = 1.645;  ///< sigmas of the noise that 95 of 100 cases do not exceed in one direction
inline constexpr double kUsualWithin = 1.25;   ///< factor to which a usual size is known: a round figure of the library
inline constexpr double kMargin = 1.15;  ///< a cause that shares its mark with those of other sides needs more than the linear model says
inline constexpr double kLeastAlternative = 1e-3;  ///< probability below which an alternative is not listed

// Models that state no tolerances: their parameters are fitted, and effects are selected by runs held out (docs/subsystem-cases.md)
inline constexpr double kHuber = 3.0;            ///< robust deviations beyond which a row counts linearly
inline constexpr double kDifference = 1e-4;      ///< of a difference: in ranges of a parameter; above the rounding of an integrated rollout
inline constexpr double kLeastGain = 1e-5;       ///< of the cost in a step, relative: less ends a fit
inline constexpr double kLeastDeviation = 1e-9;  ///< robust deviation of rows that agree exactly [sigma]
inline constexpr int kFitSteps = 40;             ///< of a fit, at most
inline constexpr int kRefitSteps = 15;           ///< the same of a refit, which starts at the fit on all rows
inline constexpr double kNearEnd = 1e-3;         ///< of a range: a fit that is drawn to an end stops this near
inline constexpr double kLeastEvidence = 5.0;    ///< that an effect has to add: 150 to 1 [nats]
inline constexpr double kDisagreement = 3.0;     ///< in favour of a set that the splits refuse; 20 to 1 [nats]
inline constexpr double kLeastErrors = 1.0;      ///< standard errors of the mean fall of the held-out gap; less comes from a few files
inline constexpr double kLeastFall = 0.005;      ///< least relevant fall of the held-out mean square; 0.25 % of the error
inline constexpr int kWeightDraws = 2000;        ///< of weights of the blocks; shares within a few per mille
inline constexpr double kUnsureShare = 0.7;      ///< probability of the first of several sets that the rows do not tell apart; below kSure
inline constexpr double kTie = 0.6;              ///< of the greatest share: such sets stand in the order of the effects; less than a nat
inline constexpr double kPlausible = 2.5;        ///< deviations of a nominal parameter; one in 80 by chance
inline constexpr double kNearFloor = 1.1;        ///< times the floor: accuracy of a floor from few repeats
inline constexpr double kStable = 0.95;          ///< share of the splits that have to agree where much of the gap remains
inline constexpr double kStructure = 3.0;        ///< times the floor: a larger gap has a cause
inline constexpr double kOtherSigma = 1.5;       ///< times a default of sigma: the rows have another one
inline constexpr double kRaised = 1.02;          ///< times the held-out error before: beyond it an effect is a false cause; less is chance
inline constexpr std::size_t kMostRows = 12000;  ///< of all files together: a fit ends in time

// Gap map and traces
inline constexpr std::size_t kCells = 4;         ///< of each experiment in the map of the gap; with fewer rows than that, one
inline constexpr double kStandsOut = 0.6;        ///< share of an experiment's excess that makes a component worth naming
inline constexpr double kLeastShare = 0.02;      ///< of the gap, below which an experiment is not listed
inline constexpr std::size_t kMostPoints = 400;  ///< of a trace: enough for a picture

// What a fit of all parameters would have claimed
inline constexpr double kPlainWidth = 30.0;  ///< prior of a build parameter in such a fit: in its sigmas as stated; 2 % becomes 60 %;
                                             ///< without any prior unseen figures run away

// What can be distinguished, and what to measure next (docs/theory/isolability.md)
inline constexpr double kSeen = 3.0;           ///< sigmas from which a misfit is detected
inline constexpr double kSimilar = 0.95;       ///< |cosine| from which one cause removes 90 % (cosine^2) of the misfit of another
inline constexpr double kNothing = 1e-12;      ///< a product of lengths that is rounding alone
inline constexpr int kHalvings = 6;            ///< of the range in which a limit's size lies; to 2 % of its logarithm
inline constexpr std::size_t kMostRivals = 4;  ///< rivals of the next experiment: each costs as much as a fit
inline constexpr double kSmallLeak = 0.05;     ///< probability below which a hypothesis gets no further experiment
inline constexpr double kDecides = 0.9;        ///< share of the entropy from which a measurement decides
inline constexpr double kWorthwhile = 0.1;     ///< share of the entropy below which a measurement is no answer
inline constexpr double kLargestFactor = 1e3;  ///< of a size that is asked for; larger effects would not change the answer

}  // namespace fusee::inference
