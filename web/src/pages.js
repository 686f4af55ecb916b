// The pages by their names in the shell. Each takes the JSON of a result and a function for further data of the page, and gives the head of its page, its sections and, where parts
// of it listen, their start.
import { assemblyPage } from "./pages/assembly.js";
import { designPage } from "./pages/design.js";
import { diagnosisPage } from "./pages/diagnosis.js";
import { identificationPage } from "./pages/identification.js";
import { paperPage } from "./pages/paper.js";
import { paretoPage } from "./pages/pareto.js";
import { scorePage } from "./pages/score.js";
import { searchPage } from "./pages/search.js";
import { simulationPage } from "./pages/simulation.js";
import { studyPage } from "./pages/study.js";

export const pages = {
  assembly: assemblyPage, design: designPage, diagnosis: diagnosisPage, identification: identificationPage, paper: paperPage, pareto: paretoPage, score: scorePage, search: searchPage, simulation: simulationPage, study: studyPage,
};
